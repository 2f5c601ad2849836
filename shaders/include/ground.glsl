// The ground's height over y = 0, m.
float groundHeight(vec2 xz) { return 0.0; }
