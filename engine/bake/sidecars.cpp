#include "engine/bake/sidecars.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "engine/bake/fill_template.hpp"
#include "engine/bake/response.hpp"
#include "engine/bake/target_frame.hpp"
#include "engine/core/atomic_file.hpp"
#include "engine/core/text.hpp"
#include "engine/io/project_json.hpp"
#include "engine/io/sha256.hpp"

namespace windloom {
namespace {

/// A number as shader languages take it: always with a point or an exponent.
std::string real(float value) {
  std::string text = shortest(value);
  if (text.find_first_of(".e") == std::string::npos) text.append(".0");
  return text;
}

/// As real(), without the noise of a product of floats.
std::string sixDigits(float value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", static_cast<double>(value));
  return real(std::strtof(text, nullptr));
}

/// Letters, digits and underscores only, for names in code.
std::string identifier(std::string_view name) {
  std::string out;
  for (const char c : name) out += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return out.empty() ? "wind" : out;
}

/// Without what would end a line, a string or a comment.
std::string harmless(std::string_view name) {
  std::string out;
  for (const char c : name) out += static_cast<unsigned char>(c) < 32 || c == '"' || c == '\\' || c == '*' ? ' ' : c;
  return out;
}

bool isImage(const std::string& path) {
  return path.ends_with(".png") || path.ends_with(".exr");
}

class Sidecars {
 public:
  Sidecars(const Project& project, const BakeHeader& header, std::span<const BakedFile> files,
           std::filesystem::path folder)
      : m_header(header), m_rules(rulesOf(header.preset)), m_files(files), m_folder(std::move(folder)) {
    describe(project);
  }

  Result<std::vector<BakedFile>> write() {
    const std::string kind = shaderKind();
    Status done = put("wind." + kind, snippet(kind));
    const auto also = [&](const char* name) {
      if (done) done = put(name, fillTemplate(sidecarTemplate(name), m_values));
    };
    if (m_header.preset == Preset::Unreal && has(isImage)) also("import_windloom.py");
    if (m_rules.vUpwards && has(isImage)) also("WindloomImport.cs");
    if (m_header.preset == Preset::Godot) {
      if (const std::string frames = godotFrames(); !frames.empty()) {
        m_values["FRAMES_FILE"] = frames;
        also("wind.gd");
      }
      if (done) done = writeGodotImports();
    }
    m_values["OWN_FRAME"] = fillTemplate(sidecarTemplate("own_frame.md"), m_values);
    m_values["VDB"] = fillTemplate(sidecarTemplate("vdb.md"), m_values);
    m_values["IMPORT"] = fillTemplate(sidecarTemplate("import_" + engine() + ".md"), m_values);
    while (m_values["IMPORT"].ends_with('\n')) m_values["IMPORT"].pop_back();
    m_values["CHECK"] = fillTemplate(sidecarTemplate(isCard() ? "check_card.md" : "check_other.md"), m_values);
    also("HOWTO.md");
    if (!done) return done.error();
    return std::move(m_written);
  }

 private:
  [[nodiscard]] std::string engine() const { return m_rules.vUpwards ? "unity" : std::string(m_rules.name); }
  [[nodiscard]] std::string shaderKind() const {
    if (m_header.preset == Preset::Godot) return "gdshaderinc";
    return m_header.preset == Preset::Generic ? "glsl" : "hlsl";
  }
  [[nodiscard]] bool isCard() const { return m_values.at("CARD") == "1"; }

  template <class Test>
  [[nodiscard]] bool has(const Test& test) const {
    return std::ranges::any_of(m_files, [&](const BakedFile& file) { return test(file.path); });
  }

  Status put(const std::string& name, const std::string& text) {
    m_written.push_back({name, "sidecar", "text"});
    return writeFileUnsynced(m_folder / name, text);
  }

  /// Tells bakes of one project from each other, so that two may lie in one game.
  [[nodiscard]] std::string checksum(const Project& project) const {
    std::string all = writeProject(project) + std::string(m_rules.name) + std::to_string(m_header.grid.resolution.x) +
                      "x" + std::to_string(m_header.grid.resolution.y) + "x" + std::to_string(m_header.frames) + "@" +
                      shortest(m_header.start) + "/" + shortest(m_header.fps);
    for (const BakedFile& file : m_files) all += file.path;
    return sha256(all).substr(0, 6);
  }

  void describe(const Project& project) {
    const TargetFrame target(m_header);
    const PresetBounds bounds = boundsIn(m_rules, m_header.grid.minCorner, m_header.grid.size);
    const float units = m_rules.unitsPerMetre;
    const glm::vec2 size = bounds.max - bounds.min;
    const bool response = std::ranges::any_of(m_files, [](const BakedFile& f) { return f.path.starts_with("bend-"); });
    m_values = {
        {"NAME", harmless(project.name)},
        {"PRESET", std::string(m_rules.name)},
        {"OTHER", m_rules.negateX ? "unity-negz" : "unity"},
        {"IDENTIFIER", identifier(project.name) + "_" + checksum(project)},
        {"AXIS_A", std::string(m_rules.axes[0])},
        {"AXIS_B", std::string(m_rules.axes[1])},
        {"LENGTH_UNIT", std::string(m_rules.lengthUnit)},
        {"SPEED_UNIT", target.unit()},
        {"UNIT", target.unit()},
        {"HANDEDNESS", std::string(m_rules.handedness)},
        {"UP", std::string(m_rules.up)},
        {"MIN_A", real(bounds.min.x)},
        {"MIN_B", real(bounds.min.y)},
        {"MAX_A", real(bounds.max.x)},
        {"MAX_B", real(bounds.max.y)},
        {"SIZE_A", real(size.x)},
        {"SIZE_B", real(size.y)},
        {"FULL_SCALE", sixDigits(target.fullScale())},
        {"FACTOR_A", real(target.factor().x)},
        {"FACTOR_B", real(target.factor().y)},
        {"FPS", real(static_cast<float>(m_header.fps))},
        {"FRAMES", real(static_cast<float>(m_header.frames))},
        {"START", real(static_cast<float>(m_header.start))},
        {"FRAME_COUNT", std::to_string(m_header.frames)},
        {"FRAME_RATE", shortest(m_header.fps)},
        {"WIDTH", std::to_string(m_header.grid.resolution.x)},
        {"HEIGHT", std::to_string(m_header.grid.resolution.y)},
        {"REFERENCE", real(m_header.profile.reference * units)},
        {"ROUGHNESS", real(m_header.profile.roughness * units)},
        {"LOOP", m_header.loop ? "1" : "0"},
        {"ONCE", m_header.loop ? "0" : "1"},
        {"LOOP_WORDS", m_header.loop ? ", repeating without a jump" : ""},
        {"NEG_X", m_rules.negateX ? "1" : "0"},
        {"NEG_Z", m_rules.negateZ ? "1" : "0"},
        {"CARD", project.solver->source == WindSource::Card ? "1" : "0"},
        {"RESPONSE", response ? "1" : "0"},
        {"BEND_FULL_SCALE", real(kBendFullScale)},
        {"SPACE_WORDS", m_header.space == FlowSpace::Uv ? ", in texture coordinates a second" : ""},
        {"SNIPPET", "wind." + shaderKind()},
        {"FORMATS", m_header.formats},
        {"SPACE_OPTION", m_header.space == FlowSpace::Uv ? " --space uv" : ""},
        {"NEGATED", m_rules.negateX ? "z instead of x" : "x instead of z"},
        {"SLAB_STRENGTH", slabStrength()},
    };
    describeBorders();
    describeFiles();
  }

  void describeBorders() {
    const bool x = m_header.periodicX, z = m_header.periodicZ;
    m_values["BORDER_WORDS"] = x && z ? "repeat: the field is periodic"
                               : x || z
                                   ? "repeat along " + std::string(m_rules.axes[x ? 0 : 1]) + ", clamp along the other"
                                   : "clamp";
    m_values["WRAP_A"] = std::string(x ? "Repeat" : "Clamp");
    m_values["WRAP_B"] = std::string(z ? "Repeat" : "Clamp");
    m_values["REPEAT"] = std::string(x || z ? "repeat_enable" : "repeat_disable");
    m_values["CLAMP_A"] = std::string(x ? "0" : "1");
    m_values["CLAMP_B"] = std::string(z ? "0" : "1");
    const glm::vec2 half = 0.5f / glm::vec2(m_header.grid.resolution);
    m_values["HALF_A"] = real(half.x);
    m_values["HALF_B"] = real(half.y);
    m_values["ADDRESS_A"] = std::string(x ? "TA_WRAP" : "TA_CLAMP");
    m_values["ADDRESS_B"] = std::string(z ? "TA_WRAP" : "TA_CLAMP");
    m_values["ROW_WORDS"] = std::string(m_rules.firstRowHigh ? "high " : "low ") + std::string(m_rules.axes[1]) +
                            (m_rules.vUpwards ? ": v = 0 is the bottom row" : ": v = 0 is the top row");
  }

  void describeFiles() {
    std::string list, test;
    for (const BakedFile& file : m_files) {
      if (!isImage(file.path)) continue;
      if (!list.empty()) list.append(",\n         ");
      list.append("\"").append(file.path).append("\"");
    }
    for (const std::string& prefix : imagePrefixes()) {
      if (!test.empty()) test.append(" || ");
      test.append("name.StartsWith(\"").append(prefix).append("\")");
    }
    m_values["FILE_LIST"] = list;
    const auto flag = [&](const char* key, auto holds) { m_values[key] = std::string(has(holds) ? "1" : "0"); };
    m_values["HAS_FULL_SCALE"] =
        std::ranges::any_of(m_files,
                            [](const BakedFile& f) { return f.encoding == "bc5" || f.encoding.starts_with("unorm"); })
            ? "1"
            : "0";
    const auto ending = [](std::string_view end) {
      return [end](const std::string& path) { return path.ends_with(end); };
    };
    flag("HAS_IMAGES",
         [](const std::string& path) { return isImage(path) && path.find("slab.") == std::string::npos; });
    flag("HAS_CODES", [](const std::string& path) { return path.find("flow.") != std::string::npos; });
    flag("HAS_ATLAS", ending("flow-atlas.png"));
    flag("HAS_DDS", ending("wind.dds"));
    flag("HAS_TEXTURES", [](const std::string& path) { return path.ends_with(".dds") || path.ends_with(".ktx2"); });
    flag("HAS_FGA", ending(".fga"));
    flag("HAS_VF", ending(".vf"));
    flag("HAS_VDB", ending(".vdb"));
    flag("HAS_PACK", ending(".windpack"));
    flag("HAS_NPY", ending(".npy"));
    flag("HAS_SLAB", [](const std::string& path) { return path.starts_with("slab."); });
    m_values["HAS_GD"] = std::string(godotFrames().empty() ? "0" : "1");
    describeTiles();
    if (test.empty()) test.append("false");
    m_values["FILE_TEST"] = test;
  }

  void describeTiles() {
    for (const char* key : {"TILES_A", "TILES_B", "TILE_COUNT"}) m_values[key] = std::string("0");
    for (const BakedFile& file : m_files) {
      if (!file.details.contains("tiles")) continue;
      const int across = file.details["tiles"][0], down = file.details["tiles"][1];
      m_values["TILES_A"] = std::to_string(across);
      m_values["TILES_B"] = std::to_string(down);
      m_values["TILE_COUNT"] = real(static_cast<float>(across * down));
    }
  }

  /// "flow.", "wind." ...: what names of images begin with.
  [[nodiscard]] std::vector<std::string> imagePrefixes() const {
    std::vector<std::string> prefixes;
    for (const BakedFile& file : m_files) {
      std::string prefix = file.path.substr(0, file.path.find('.') + 1);
      if (isImage(file.path) && std::ranges::find(prefixes, prefix) == prefixes.end()) prefixes.push_back(prefix);
    }
    return prefixes;
  }

  [[nodiscard]] std::string slabStrength() const {
    for (const BakedFile& file : m_files) {
      if (file.details.contains("strength")) return shortest(file.details["strength"].get<float>());
    }
    return "as manifest.json says";
  }

  /// The file that loads as Texture2DArray, for wind.gd.
  [[nodiscard]] std::string godotFrames() const {
    if (m_header.frames < 2) return {};  // one frame is a plain texture
    for (const char* name : {"wind.dds", "wind-rgba.dds", "flow-atlas.png"}) {
      if (has([&](const std::string& path) { return path == name; })) return name;
    }
    return {};
  }

  /// Beside every image what Godot needs to import it as numbers. A format that knows more says so in its "import".
  Status writeGodotImports() {
    for (const BakedFile& file : m_files) {
      if (!isImage(file.path)) continue;
      if (Status done = put(file.path + ".import", godotImport(file)); !done) return done;
    }
    return Done{};
  }

  static std::string godotImport(const BakedFile& file) {
    nlohmann::ordered_json settings;
    if (file.details.contains("import")) {
      settings = file.details["import"];
    } else if (file.details.contains("tiles")) {
      settings = {{"importer", "2d_array_texture"},
                  {"type", "CompressedTexture2DArray"},
                  {"compress/mode", 3},
                  {"compress/channel_pack", 1},
                  {"mipmaps/generate", false},
                  {"slices/horizontal", file.details["tiles"][0]},
                  {"slices/vertical", file.details["tiles"][1]}};
    } else {
      // Floats stay as they are (VRAM uncompressed), bytes lossless.
      settings = {{"importer", "texture"},
                  {"type", "CompressedTexture2D"},
                  {"compress/mode", file.path.ends_with(".exr") ? 3 : 0},
                  {"mipmaps/generate", false},
                  {"process/fix_alpha_border", false},
                  {"process/hdr_as_srgb", false},
                  {"detect_3d/compress_to", 0}};
    }
    std::string remap = "[remap]\n\n", params = "\n[params]\n\n";
    for (const auto& [key, value] : settings.items())
      (key == "importer" || key == "type" ? remap : params) += key + "=" + value.dump() + "\n";
    return remap + params;
  }

  /// The shader code: the part that all languages share, in this one's words.
  std::string snippet(const std::string& kind) {
    std::string core = fillTemplate(sidecarTemplate("wind.core"), m_values);
    using Words = std::vector<std::pair<std::string_view, std::string_view>>;
    const Words hlsl = {{"CONST ", "static const "}, {"vec2", "float2"}, {"vec3", "float3"},
                        {"vec4", "float4"},          {"mix(", "lerp("},  {"fract(", "frac("}};
    const Words glsl = {{"CONST ", "const "}};
    for (const auto& [from, to] : kind == "hlsl" ? hlsl : glsl) {
      for (std::size_t at = core.find(from); at != std::string::npos; at = core.find(from, at + to.size()))
        core.replace(at, from.size(), to);
    }
    m_values["CORE"] = core;
    return fillTemplate(sidecarTemplate("wind." + kind), m_values);
  }

  const BakeHeader& m_header;
  const PresetRules& m_rules;
  std::span<const BakedFile> m_files;
  std::filesystem::path m_folder;
  TemplateValues m_values;
  std::vector<BakedFile> m_written;
};

}  // namespace

Result<std::vector<BakedFile>> writeSidecars(const Project& project, const BakeHeader& header,
                                             std::span<const BakedFile> files, const std::filesystem::path& folder) {
  return Sidecars(project, header, files, folder).write();
}

}  // namespace windloom
