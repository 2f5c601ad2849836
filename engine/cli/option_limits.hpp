#pragma once
// The greatest sizes and counts that options of the command line take; docs/limits.md is made from them.

namespace windloom::cli {

inline constexpr int kMaxBakeSide = 8192;          ///< cells; as for wind packs
inline constexpr int kMaxRenderSide = 16384;       ///< pixels
inline constexpr int kMaxRenderCells = 4096;       ///< per side, as for a field
inline constexpr int kMaxRenderFrames = 100'000;   ///< pictures of one run
inline constexpr int kMaxBenchPictureSide = 8192;  ///< pixels; the scene picture draws twice that
inline constexpr int kMaxBakeLayers = 128;         ///< of volumes
inline constexpr double kMaxSeconds = 1e6;         ///< of simulated time, eleven days
inline constexpr long kMaxSteps = 100'000'000;     ///< of the solver

}  // namespace windloom::cli
