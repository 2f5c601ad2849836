#include "engine/gpu/pass_state.hpp"

#include <epoxy/gl.h>

namespace windloom::gpu {
namespace {

void enable(GLenum what, bool on) {
  on ? glEnable(what) : glDisable(what);
}

GLenum compareFunction(const PassState& state) {
  if (state.depth == Depth::Write) return GL_ALWAYS;
  switch (state.compare) {
    case DepthCompare::Less:
      return GL_LESS;
    case DepthCompare::LessEqual:
      return GL_LEQUAL;
    case DepthCompare::Greater:
      return GL_GREATER;
    case DepthCompare::GreaterEqual:
      return GL_GEQUAL;
    case DepthCompare::Equal:
      return GL_EQUAL;
  }
  return GL_LEQUAL;
}

void applyBlend(Blend blend) {
  enable(GL_BLEND, blend != Blend::Off);
  glBlendEquation(GL_FUNC_ADD);
  switch (blend) {
    case Blend::Off:
      break;
    case Blend::Alpha:
      glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
      break;
    case Blend::Premultiplied:
      glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
      break;
    case Blend::Additive:
      glBlendFunc(GL_ONE, GL_ONE);
      break;
  }
}

}  // namespace

void apply(const PassState& state) {
  glBindFramebuffer(GL_FRAMEBUFFER, state.framebuffer);
  glViewport(state.viewport.x, state.viewport.y, state.viewport.z, state.viewport.w);
  enable(GL_SCISSOR_TEST, state.scissor.has_value());
  if (state.scissor) glScissor(state.scissor->x, state.scissor->y, state.scissor->z, state.scissor->w);
  enable(GL_DEPTH_TEST, state.depth != Depth::Off);
  glDepthFunc(compareFunction(state));
  glDepthMask(state.depth == Depth::TestAndWrite || state.depth == Depth::Write);
  applyBlend(state.blend);
  enable(GL_CULL_FACE, state.cull != Cull::None);
  glCullFace(state.cull == Cull::Front ? GL_FRONT : GL_BACK);
  glFrontFace(GL_CCW);
  const GLboolean colour = state.colour == Colour::Write;
  glColorMask(colour, colour, colour, colour);
  enable(GL_SAMPLE_ALPHA_TO_COVERAGE, state.coverage == Coverage::FromAlpha);
  enable(GL_FRAMEBUFFER_SRGB, state.srgb == Srgb::Encode);
  const bool offset = state.depthOffset != glm::vec2(0.0f);
  enable(GL_POLYGON_OFFSET_FILL, offset);
  glPolygonOffset(state.depthOffset.x, state.depthOffset.y);
  glDisable(GL_STENCIL_TEST);
  glEnable(GL_MULTISAMPLE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

}  // namespace windloom::gpu
