#pragma once
// Project files as text, for the tests of reading and writing.

#include <algorithm>
#include <string>
#include <vector>

#include "engine/core/file.hpp"
#include "engine/io/project_json.hpp"

namespace windloom {

/// A project with one record of every kind, and unknown keys in many places.
inline const std::string kRichProject = R"json({
  "format": "windloom-project", "version": 1, "name": "Rich \"meadow\" ü",
  "field": {"centre": [1, -2], "size": [50, 25], "resolution": [100, 50], "timeStep": 0.02, "later": [1, {"a": null}],
            "borders": {"xMin": "periodic", "xMax": "periodic", "zMin": "wall", "floor": "moss"}},
  "solver": {"backend": "cpu", "seed": 9},
  "ambient": {"speed": 2, "gusts": {"strength": 0.3, "colour": "blue"}},
  "graph": {
    "points": [{"id": 1, "name": "gate", "position": [-10, 0]}, {"id": 2, "position": [0.1, 5], "tag": 1e-3},
      {"id": 3, "position": [7, 2]}],
    "arrows": [{"id": 10, "from": 1, "to": 2, "strength": 9, "swirl": -1.5},
      {"id": 11, "from": 2, "to": 3, "muted": true}],
    "signals": [{"root": 1, "kind": "curve", "period": 4, "keys": [[0, 0], [1.25, 1], [4, 0]]}],
    "layers": {"x": 1}
  },
  "obstacles": [{"id": 30, "shape": "box", "centre": [5, -8], "size": [3, 1], "rotation": 30}],
  "terrain": {"kind": "flat"},
  "grass": {"density": 40, "shadow": {"min": 0.5}, "maps": {"density": "assets/mask.png", "wet": 1}},
  "bezier": {"tufts": {"share": 0.6, "moss": 2}, "blade": {"form": "quadratic"}, "wind": {"source": "both"},
             "gravity": {"direction": [0, -2, 0.5]}, "collision": {"fade": 0.2}, "dew": true},
  "shell": {"shells": 12, "method": "plain", "texture": {"tile": 2.5, "file": "assets/blades.png", "ply": 2},
            "bend": {"stiffnessCurve": 0.7}, "wind": {"source": "both", "sampling": "texel", "sourcePosition": [3, -4]},
            "mow": "weekly"},
  "species": [{"id": 60, "shape": "daisy", "weight": 0.1, "colours": {"tip": [1, 1, 0.9]}},
    {"id": 61, "name": "tuft", "shape": "mesh", "file": "assets/tuft.glb", "season": "may"}],
  "colliders": [{"id": 70, "shape": "sphere", "position": [2, 3], "radius": 0.4, "mass": 3,
                 "keys": [[0, 0, 0, 0], [1.5, 4, 0.25, -2]]},
    {"id": 71, "shape": "mesh", "position": [0, 0], "file": "assets/rock.glb"}],
  "surfaces": [{"id": 80, "name": "band", "shape": "moebius", "position": [1, 2], "size": 6, "tilt": 20,
                "density": 900, "bothSides": true},
    {"id": 81, "shape": "mesh", "position": [4, 4], "file": "assets/stone.glb", "grain": 3}],
  "rotors": [{"id": 90, "position": [-3, 1], "radius": 4, "rings": 0.8, "noise": "loud"}],
  "probes": [{"id": 40, "position": [3, 4]}],
  "cameras": [{"id": 50, "name": "hero", "position": [0, 2, 9]}],
  "studio": {"owner": "Ada", "big": 18446744073709551615}
})json";

inline std::string brokenFile(const std::string& name) {
  return WINDLOOM_TEST_DATA "/broken/" + name + ".wind.json";
}

/// The pointers of the problems, sorted; empty where the text is a valid project.
inline std::vector<std::string> problemPointers(const Result<LoadedProject>& loaded) {
  std::vector<std::string> pointers;
  for (const Problem& problem : loaded ? loaded->missing : loaded.error().problems) pointers.push_back(problem.pointer);
  std::ranges::sort(pointers);
  return pointers;
}

}  // namespace windloom
