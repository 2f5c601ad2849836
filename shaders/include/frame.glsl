// The frame's uniforms and views of a place on the ground.
#include "shaders/shared/frame_block.h"
#include "shaders/shared/render_bindings.h"

layout(std140, binding = RENDER_UBO_FRAME) uniform FrameUniforms { FrameBlock frame; };

bool isOrthographic() { return frame.cameraPosition.w > 0.5; }

// Unit vector from a point to the camera.
vec3 directionToCamera(vec3 world) {
  return isOrthographic() ? -frame.viewForward.xyz : normalize(frame.cameraPosition.xyz - world);
}

// Pixels that one metre covers at a point.
float pixelsPerMetre(vec3 world) {
  if (isOrthographic()) return frame.pixelScale.x;
  return frame.pixelScale.x / max(dot(world - frame.cameraPosition.xyz, frame.viewForward.xyz), 0.05);
}
