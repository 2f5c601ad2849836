#pragma once
// What the probes feel: speed over the last seconds, and the wind now.

#include <map>
#include <vector>

#include "editor/panels/panel_context.hpp"

namespace windloom::editor {

class ProbePanel {
 public:
  /// Looks at the wind at every probe. Call once a frame, drawn or not, after the session advanced.
  void sample(PanelContext& context);
  void draw(PanelContext& context);

 private:
  static constexpr std::size_t kSamples = 240;
  struct Trace {
    std::vector<float> speedMps;  ///< a ring of kSamples
    std::size_t next = 0;
    glm::vec2 now{0.0f};
    bool live = false;  ///< its probe still exists
  };
  std::map<Id, Trace> m_traces;
  double m_sampledAt = -1;
};

}  // namespace windloom::editor
