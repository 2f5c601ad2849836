// Where the passes of the scene put their light.
layout(location = 0) out vec4 sceneColour;

void writeScene(vec3 light) { sceneColour = vec4(light, 1.0); }
