#pragma once
// How strongly each place of each arrow blows now, as a table for the shaders: for every root that blows, its signal
// at the delays that its arrows have, evenly spaced. An arrow's mark says which stretch of the table is its own. So a
// frame costs a few values per root, however many arrows there are, and roots that blow steadily cost nothing.

#include <span>
#include <vector>

#include "engine/model/evaluate.hpp"
#include "engine/model/graph_links.hpp"

namespace windloom {

class OverlaySignals {
 public:
  /// A stretch of the table: `first` entries from its begin at the arrow's start, `span` more up to its end.
  struct Stretch {
    float first = 0.0f, span = 0.0f;
  };

  /// Lays out the table. `evaluator` may be null: everything blows fully.
  void build(const WindGraph& graph, const GraphLinks& links, const GraphEvaluator* evaluator);

  /// The stretch of an arrow of the graph; those with a missing end have none (0, 0).
  [[nodiscard]] Stretch stretch(std::size_t arrow) const { return m_stretches[arrow]; }

  /// Brings the table to a time, s. True where an entry changed.
  bool refresh(double time);
  /// Factors on the strength, 0 and up; never empty. An entry follows each stretch's last one.
  [[nodiscard]] std::span<const float> levels() const { return m_levels; }

 private:
  struct Track {
    Signal signal;
    double firstDelay = 0, lastDelay = 0, step = 0;  // s
    std::size_t begin = 0, count = 0;                // in m_levels
    double steadyFrom = 0;                           // s: 1 from then on
    bool steady = false;                             // and filled so
  };
  std::vector<Track> makeTracks(const WindGraph& graph, const GraphLinks& links, const GraphEvaluator& evaluator,
                                std::vector<std::uint32_t>& trackOfArrow);
  void layOut(std::size_t arrows);

  std::vector<Track> m_tracks;
  std::vector<Stretch> m_stretches;
  std::vector<float> m_levels;
  double m_time = -1;
};

}  // namespace windloom
