#include "engine/bake/graph_gltf.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "engine/core/atomic_file.hpp"
#include "engine/core/contract.hpp"
#include "engine/core/text.hpp"
#include "engine/model/evaluate.hpp"
#include "engine/model/graph_links.hpp"
#include "engine/model/parameters.hpp"
#include "engine/model/signal_curve.hpp"

namespace windloom {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "glTF's buffers are little-endian");

/// A float as the double of its shortest decimal text; no -0.
double plain(float value) {
  return value == 0.0f ? 0.0 : parseNumber(shortest(value)).value_or(0.0);
}

Json triple(glm::vec3 value) {
  return {plain(value.x), plain(value.y), plain(value.z)};
}

Json jsonOf(const ParameterInfo& info, const ParameterValue& value) {
  struct Visitor {
    const ParameterInfo& info;
    Json operator()(float v) const { return plain(v); }
    Json operator()(int v) const {
      return info.type == ParameterType::Choice ? Json(info.choices[static_cast<std::size_t>(v)]) : Json(v);
    }
    Json operator()(bool v) const { return v; }
    Json operator()(glm::vec2 v) const { return {plain(v.x), plain(v.y)}; }
    Json operator()(glm::vec3 v) const { return triple(v); }
    Json operator()(glm::ivec2 v) const { return {v.x, v.y}; }
    Json operator()(const std::string& v) const { return v; }
  };
  return std::visit(Visitor{info}, value);
}

/// The settings of a record under the keys of the project file.
template <class Owner>
void addSettings(Json& extras, const Owner& owner) {
  for (const Parameter<Owner>& parameter : parametersOf<Owner>())
    extras[std::string(parameter.info.key)] = jsonOf(parameter.info, parameter.get(owner));
}

Json signalOf(const WindGraph& graph, Id root) {
  const Signal* found = findSignal(graph, root);
  Signal signal = found != nullptr ? *found : Signal{};
  signal.root = root;
  Json json = Json::object();
  addSettings(json, signal);
  for (const SignalKey& key : signal.keys) {
    json["keys"].push_back({plain(key.time), plain(key.value), kEasings[static_cast<std::size_t>(key.easing)]});
  }
  return json;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t n) {
      return n < bytes.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[n])) : 0u;
    };
    const std::uint32_t group = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    for (std::size_t n = 0; n < 4; ++n) text += i + n > bytes.size() ? '=' : kDigits[group >> (18 - 6 * n) & 63u];
  }
  return text;
}

class Scene {
 public:
  Scene(const Project& project)
      : m_graph(*project.graph),
        m_heights(project.terrain->heights.get()),
        m_links(m_graph),
        m_arrivals(GraphEvaluator(m_graph).arrivals()) {}

  Json text(Json wind) {
    // In the order of the roots' ids, so that the same graph gives the same file.
    std::map<Id, std::vector<std::size_t>> trees;
    for (std::size_t a = 0; a < m_graph.arrows.size(); ++a) {
      if (m_links.from[a] != GraphLinks::kNone) trees[m_arrivals[m_links.from[a]].root].push_back(a);
    }
    for (const auto& [root, arrows] : trees) addTree(root, arrows);
    Json scene = {{"name", "wind"}};
    if (!m_roots.empty()) scene["nodes"] = m_roots;
    scene["extras"] = {{"wind", std::move(wind)}};
    Json gltf = {{"asset", {{"version", "2.0"}, {"generator", "windloom " WINDLOOM_VERSION}}},
                 {"scene", 0},
                 {"scenes", Json::array({std::move(scene)})}};
    // glTF has no empty lists.
    if (m_roots.empty()) return gltf;
    gltf["nodes"] = std::move(m_nodes);
    gltf["meshes"] = std::move(m_meshes);
    const Json blue = {{"name", "wind"},
                       {"pbrMetallicRoughness", {{"baseColorFactor", {0.1, 0.5, 0.9, 1}}, {"metallicFactor", 0}}},
                       {"emissiveFactor", {0.1, 0.5, 0.9}}};
    gltf["materials"] = Json::array({blue});
    gltf["accessors"] = std::move(m_accessors);
    const Json view = {{"buffer", 0}, {"byteLength", m_bytes.size()}, {"byteStride", 12}, {"target", 34962}};
    gltf["bufferViews"] = Json::array({view});
    const Json buffer = {{"byteLength", m_bytes.size()},
                         {"uri", "data:application/octet-stream;base64," + base64(m_bytes)}};
    gltf["buffers"] = Json::array({buffer});
    return gltf;
  }

 private:
  [[nodiscard]] glm::vec3 placeOf(std::uint32_t point) const {
    const glm::vec2 place = m_graph.points[point].position;
    return {place.x, m_heights != nullptr ? heightAt(*m_heights, place) : 0.0f, place.y};
  }

  void addTree(Id root, const std::vector<std::size_t>& arrows) {
    const Point* point = findPoint(m_graph, root);
    WL_REQUIRE(point != nullptr, "every arrow is reached from a root");
    const auto index = static_cast<std::uint32_t>(point - m_graph.points.data());
    const std::string id = std::to_string(root);
    Json extras = {{"kind", "tree"}, {"root", root}, {"arrows", arrows.size()}, {"signal", signalOf(m_graph, root)}};
    const glm::vec3 origin = placeOf(index);
    Json children = Json::array();
    m_roots.push_back(m_nodes.size());
    const std::size_t own = m_nodes.size();
    m_nodes.push_back({{"name", "AGC_" + (m_graph.points[index].name.empty() ? id : m_graph.points[index].name)},
                       {"translation", triple(origin)},
                       {"mesh", m_meshes.size()}});
    std::vector<glm::vec3> lines;
    for (const std::size_t arrow : arrows) {
      children.push_back(m_nodes.size());
      addArrow(arrow, origin, root, lines);
    }
    m_nodes[own]["children"] = std::move(children);
    m_nodes[own]["extras"] = std::move(extras);
    addMesh(lines);
  }

  void addArrow(std::size_t a, glm::vec3 origin, Id root, std::vector<glm::vec3>& lines) {
    const Arrow& arrow = m_graph.arrows[a];
    const std::uint32_t from = m_links.from[a], to = m_links.to[a];
    const glm::vec3 start = placeOf(from) - origin, end = placeOf(to) - origin;
    const double length = static_cast<double>(glm::length(m_graph.points[to].position - m_graph.points[from].position));
    const bool tip = m_links.outgoing(to).empty();
    Json extras = {{"kind", m_graph.points[from].id == root ? "root" : tip ? "tip" : "branch"}};
    addSettings(extras, arrow);
    extras["length"] = length;
    extras["reached"] = m_arrivals[from].time;  // s after the root's onset
    m_nodes.push_back({{"name", arrow.name.empty() ? "arrow " + std::to_string(arrow.id) : arrow.name},
                       {"translation", triple(start)},
                       {"rotation", headingOf(start, end)},
                       {"extras", std::move(extras)}});
    addLines(start, end, lines);
  }

  /// The turn about +Y that brings +Z to the way from `start` to `end`.
  static Json headingOf(glm::vec3 start, glm::vec3 end) {
    const double angle = std::atan2(static_cast<double>(end.x - start.x), static_cast<double>(end.z - start.z));
    return {0, plain(static_cast<float>(std::sin(0.5 * angle))), 0, plain(static_cast<float>(std::cos(0.5 * angle)))};
  }

  /// The shaft and two barbs, which show its direction.
  static void addLines(glm::vec3 start, glm::vec3 end, std::vector<glm::vec3>& lines) {
    const glm::vec3 way = end - start;
    const glm::vec3 aside(-way.z, 0.0f, way.x);
    const float barb = std::min(0.15f, 1.0f / glm::length(way));  // part of the shaft: at most 1 m
    lines.insert(lines.end(),
                 {start, end, end, end - barb * (way + 0.5f * aside), end, end - barb * (way - 0.5f * aside)});
  }

  void addMesh(const std::vector<glm::vec3>& lines) {
    glm::vec3 low = lines.front(), high = lines.front();
    for (const glm::vec3 v : lines) {
      low = glm::min(low, v);
      high = glm::max(high, v);
    }
    Json accessor = {{"bufferView", 0}};
    if (!m_bytes.empty()) accessor["byteOffset"] = m_bytes.size();
    accessor["componentType"] = 5126;
    accessor["count"] = lines.size();
    accessor["type"] = "VEC3";
    accessor["min"] = triple(low);
    accessor["max"] = triple(high);
    m_bytes.append(reinterpret_cast<const char*>(lines.data()), lines.size() * sizeof(glm::vec3));
    const Json primitive = {{"attributes", {{"POSITION", m_accessors.size()}}}, {"mode", 1}, {"material", 0}};
    m_meshes.push_back({{"primitives", Json::array({primitive})}});
    m_accessors.push_back(std::move(accessor));
  }

  const WindGraph& m_graph;
  const HeightField* m_heights;
  GraphLinks m_links;
  std::vector<Arrival> m_arrivals;
  Json m_roots = Json::array(), m_nodes = Json::array(), m_meshes = Json::array(), m_accessors = Json::array();
  std::string m_bytes;
};

}  // namespace

std::string graphGltfText(const Project& project, const BakeHeader& header, std::span<const BakedFile> files) {
  Json wind = {{"version", 1}, {"project", project.name}, {"manifest", "manifest.json"}};
  wind["time"] = {{"fps", header.fps}, {"frames", header.frames}, {"start", header.start}, {"loop", header.loop}};
  wind["maps"] = Json::array();
  for (const BakedFile& file : files)
    wind["maps"].push_back({{"path", file.path}, {"role", file.role}, {"encoding", file.encoding}});
  // A name may hold bytes that aren't UTF-8; they are replaced rather than thrown about.
  return Scene(project).text(std::move(wind)).dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<BakedFile> writeGraphGltf(const Project& project, const BakeHeader& header, std::span<const BakedFile> files,
                                 const std::filesystem::path& folder) {
  const Status written = writeFileUnsynced(folder / "graph.gltf", graphGltfText(project, header, files));
  if (!written) return written.error();
  return BakedFile{
      "graph.gltf", "graph", "text", {{"coordinates", {{"handedness", "right"}, {"up", "+Y"}}}, {"lengthUnit", "m"}}};
}

}  // namespace windloom
