// What lets the other headers of this folder be read as C++ and as GLSL: vector names and function
// qualifiers. C++ sees them in namespace windloom::shared.
#ifndef WINDLOOM_SHARED_LANGUAGE_H
#define WINDLOOM_SHARED_LANGUAGE_H
#ifdef __cplusplus
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
namespace windloom::shared {
using uint = std::uint32_t;
using glm::ivec2;
using glm::mat4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
}  // namespace windloom::shared
#define WL_SHARED_BEGIN namespace windloom::shared {
#define WL_SHARED_END }
#define WL_FUNCTION inline
#else
#define WL_SHARED_BEGIN
#define WL_SHARED_END
#define WL_FUNCTION
#endif
#endif
