#pragma once
// The game's shaders, GLSL 3.30: shaders.cpp has one text for each stage and what they share.

namespace game {

struct ShaderPair {
  const char* vertex;
  const char* fragment;
};

extern const char* const kSharedShader;  ///< #version, the scene's uniforms, sun, haze and tone
extern const ShaderPair kSkyShader, kHillShader, kWoodShader, kGroundShader, kBladeShader;
extern const ShaderPair kLeafShader, kClothShader, kPoleShader, kStreakShader;
extern const char* const kShadowFragment;  ///< instead of the fragment shader, when a thing's shadow is drawn

}  // namespace game
