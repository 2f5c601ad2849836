// Where the passes of the scene put their light.
#include "shaders/include/tone_map.glsl"

layout(location = 0) out vec4 sceneColour;

void writeScene(vec3 light) { sceneColour = vec4(toPicture(light), 1.0); }
