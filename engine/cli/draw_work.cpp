#include "engine/cli/draw_work.hpp"

#include <epoxy/gl.h>

#include "engine/gpu/handle.hpp"

namespace windloom::cli {
namespace {

class Count {
 public:
  explicit Count(GLenum target) : m_target(target) {
    GLuint name = 0;
    glGenQueries(1, &name);
    m_query = gpu::Handle<gpu::QueryKind>(name);
    glBeginQuery(m_target, name);
  }
  [[nodiscard]] long long end() const {
    glEndQuery(m_target);
    GLuint64 count = 0;
    glGetQueryObjectui64v(m_query.name(), GL_QUERY_RESULT, &count);
    return static_cast<long long>(count);
  }

 private:
  GLenum m_target;
  gpu::Handle<gpu::QueryKind> m_query;
};

}  // namespace

DrawWork drawWork(const std::function<void()>& draw) {
  const bool counted = epoxy_has_gl_extension("GL_ARB_pipeline_statistics_query");
  DrawWork work;
  const Count triangles(GL_PRIMITIVES_GENERATED);
  if (counted) {
    const Count fragments(GL_FRAGMENT_SHADER_INVOCATIONS_ARB);
    draw();
    work.fragments = fragments.end();
  } else {
    draw();
  }
  work.triangles = triangles.end();
  return work;
}

}  // namespace windloom::cli
