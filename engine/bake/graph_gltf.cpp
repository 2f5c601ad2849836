#include "engine/bake/graph_gltf.hpp"

#include "engine/core/file.hpp"

namespace windloom {

Result<BakedFile> writeGraphGltf(const Project& project, const BakeHeader&, std::span<const BakedFile>,
                                 const std::filesystem::path& folder) {
  nlohmann::ordered_json scene = {{"asset", {{"version", "2.0"}, {"generator", "windloom"}}}};
  scene["nodes"] = nlohmann::ordered_json::array();
  for (const Point& point : project.graph->points)
    scene["nodes"].push_back({{"translation", {point.position.x, 0.0f, point.position.y}}});
  if (Status written = writeFileAtomically(folder / "graph.gltf", scene.dump(1)); !written) return written.error();
  return BakedFile{"graph.gltf", "graph", "text"};
}

}  // namespace windloom
