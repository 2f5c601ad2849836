#pragma once
// The speeds of the wind as it blows now, against the full scale of formats of 8 or 16 bits.

#include "editor/core/speed_histogram.hpp"
#include "engine/session/session.hpp"

namespace windloom::editor {

class ClippingView {
 public:
  /// After the session advanced: looks at the wind twice a second. `fullScale` in m/s; 0: the fastest wind's.
  void sample(Session& session, double seconds, float fullScale);
  void draw() const;

 private:
  SpeedHistogram m_histogram;
  float m_fullScale = 0;
  long m_number = 0;  // of the field that was counted
  double m_at = -1;
};

}  // namespace windloom::editor
