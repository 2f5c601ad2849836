#include "engine/io/project_schema.hpp"

#include <cmath>

#include "engine/core/text.hpp"
#include "engine/io/json_document.hpp"
#include "engine/io/project_json.hpp"
#include "engine/io/project_records.hpp"
#include "engine/model/outline.hpp"
#include "engine/model/parameters.hpp"
#include "engine/model/signal_curve.hpp"
#include "engine/model/validate.hpp"

namespace windloom {
namespace {

using Schema = JsonDocument;

Schema bound(double value) {
  return value == std::floor(value) && std::abs(value) < 1e15 ? Schema(static_cast<std::int64_t>(value))
                                                              : Schema(value);
}

/// A float as its shortest decimal instead of as the double it converts to.
Schema floatJson(float value) {
  return bound(*parseNumber(shortest(value)));
}

Schema valueJson(const ParameterInfo& info, const ParameterValue& value) {
  struct Visitor {
    const ParameterInfo& info;
    Schema operator()(float v) const { return floatJson(v); }
    Schema operator()(int v) const {
      return info.type == ParameterType::Choice ? Schema(info.choices[static_cast<std::size_t>(v)]) : Schema(v);
    }
    Schema operator()(bool v) const { return v; }
    Schema operator()(glm::vec2 v) const { return Schema::array({floatJson(v.x), floatJson(v.y)}); }
    Schema operator()(glm::vec3 v) const { return Schema::array({floatJson(v.x), floatJson(v.y), floatJson(v.z)}); }
    Schema operator()(glm::ivec2 v) const { return Schema::array({v.x, v.y}); }
    Schema operator()(const std::string& v) const { return v; }
  };
  return std::visit(Visitor{info}, value);
}

Schema numberSchema(const char* type, double min, double max) {
  return {{"type", type}, {"minimum", bound(min)}, {"maximum", bound(max)}};
}

Schema tupleSchema(const Schema& item, std::size_t count) {
  return {{"type", "array"}, {"items", item}, {"minItems", count}, {"maxItems", count}};
}

Schema typeSchema(const ParameterInfo& info) {
  switch (info.type) {
    case ParameterType::Real:
      return numberSchema("number", info.min, info.max);
    case ParameterType::Integer:
    case ParameterType::Id:
      return numberSchema("integer", info.min, info.max);
    case ParameterType::Switch:
      return {{"type", "boolean"}};
    case ParameterType::Choice:
      return {{"enum", info.choices}};
    case ParameterType::Real2:
      return tupleSchema(numberSchema("number", info.min, info.max), 2);
    case ParameterType::Real3:
      return tupleSchema(numberSchema("number", info.min, info.max), 3);
    case ParameterType::Integer2:
      return tupleSchema(numberSchema("integer", info.min, info.max), 2);
    case ParameterType::Text:
      break;
  }
  return {{"type", "string"}, {"maxLength", kMaxTextBytes}, {"pattern", "^[^\\u0000-\\u001f\\u007f]*$"}};
}

template <class Owner>
Schema ownerSchema() {
  static const Owner kDefault{};
  Schema properties = Schema::object();
  for (const Parameter<Owner>& parameter : parametersOf<Owner>()) {
    const ParameterInfo& info = parameter.info;
    Schema entry = typeSchema(info);
    entry["description"] = std::string(info.help) + (info.unit.empty() ? "" : " Unit: " + std::string(info.unit) + ".");
    if (info.type != ParameterType::Id) entry["default"] = valueJson(info, parameter.get(kDefault));
    const std::size_t slash = info.key.find('/');
    if (slash == info.key.npos) {
      properties[std::string(info.key)] = std::move(entry);
    } else {
      Schema& group = properties[std::string(info.key.substr(0, slash))];
      group["type"] = "object";
      group["properties"][std::string(info.key.substr(slash + 1))] = std::move(entry);
    }
  }
  Schema schema{{"type", "object"}, {"properties", std::move(properties)}};
  if constexpr (!kRequiredKeys<Owner>.empty()) schema["required"] = kRequiredKeys<Owner>;
  return schema;
}

Schema signalSchema() {
  Schema schema = ownerSchema<Signal>();
  const Schema pair{{"type", "array"},
                    {"prefixItems",
                     {numberSchema("number", 0, static_cast<double>(kMaxSignalKeyTimeS)),
                      numberSchema("number", 0, static_cast<double>(kMaxSignalKeyValue)), Schema{{"enum", kEasings}}}},
                    {"minItems", 2},
                    {"maxItems", 3}};
  schema["properties"]["keys"] = {
      {"type", "array"},
      {"items", pair},
      {"maxItems", kMaxSignalKeys},
      {"description",
       "Keys [time in s, factor] or [time in s, factor, easing to the next key], times ascending; curve."}};
  return schema;
}

Schema obstacleSchema() {
  Schema schema = ownerSchema<Obstacle>();
  const double reach = static_cast<double>(kMaxCornerM);
  schema["properties"]["points"] = {
      {"type", "array"},
      {"items", tupleSchema(numberSchema("number", -reach, reach), 2)},
      {"minItems", kMinCorners},
      {"maxItems", kMaxCorners},
      {"description",
       "Corners [x, z] from the centre along its own axes, in order around; sides don't cross; polygon. Unit: m."}};
  return schema;
}

Schema colliderSchema() {
  Schema schema = ownerSchema<Collider>();
  const double reach = static_cast<double>(kMaxColliderOffsetM);
  const Schema offset = numberSchema("number", -reach, reach);
  const Schema key{
      {"type", "array"},
      {"prefixItems", {numberSchema("number", 0, static_cast<double>(kMaxColliderKeyTimeS)), offset, offset, offset}},
      {"minItems", 4},
      {"maxItems", 4}};
  schema["properties"]["keys"] = {
      {"type", "array"},
      {"items", key},
      {"maxItems", kMaxColliderKeys},
      {"description", "Keys [time in s, x, height, z]: how far it is from its place then, in m; times ascending."}};
  return schema;
}

Schema listOf(Schema item, std::size_t limit) {
  return {{"type", "array"}, {"items", std::move(item)}, {"maxItems", limit}};
}

Schema graphSchema() {
  return {{"type", "object"},
          {"properties",
           {{"points", listOf(ownerSchema<Point>(), kMaxPoints)},
            {"arrows", listOf(ownerSchema<Arrow>(), kMaxArrows)},
            {"signals", listOf(signalSchema(), kMaxPoints)}}}};
}

std::string rangeText(const ParameterInfo& info) {
  switch (info.type) {
    case ParameterType::Switch:
      return "true, false";
    case ParameterType::Text:
      return "text";
    case ParameterType::Choice:
      break;
    default:
      return parameterRange(info);
  }
  std::string names;
  for (const std::string_view name : info.choices) names.append(names.empty() ? "" : ", ").append(name);
  return names;
}

template <class Owner>
void appendTable(std::string& text, const char* title, const char* pointer) {
  static const Owner kDefault{};
  text.append("\n## ").append(title).append("\n`").append(pointer).append("`\n\n");
  text.append("| key | label | unit | range | default | meaning |\n|---|---|---|---|---|---|\n");
  for (const Parameter<Owner>& parameter : parametersOf<Owner>()) {
    const ParameterInfo& info = parameter.info;
    const bool telling = info.type != ParameterType::Id && info.type != ParameterType::Text;
    std::string standard = telling ? valueJson(info, parameter.get(kDefault)).dump() : "";
    for (const std::string_view cell : std::initializer_list<std::string_view>{info.key, info.label, info.unit}) {
      text.append("| ").append(cell).append(cell.empty() ? "" : " ");
    }
    text.append("| ").append(rangeText(info)).append(" | ").append(standard).append(standard.empty() ? "" : " ");
    text.append("| ").append(info.help).append(" |\n");
  }
}

}  // namespace

std::string projectSchemaJson() {
  Schema properties{{"format", {{"const", kProjectFormat}}},
                    {"version", {{"const", kProjectVersion}}},
                    {"name", typeSchema(kProjectName)}};
  properties["field"] = ownerSchema<FieldSettings>();
  properties["solver"] = ownerSchema<SolverSettings>();
  properties["ambient"] = ownerSchema<AmbientWind>();
  properties["graph"] = graphSchema();
  properties["obstacles"] = listOf(obstacleSchema(), kMaxObstacles);
  properties["terrain"] = ownerSchema<TerrainSettings>();
  properties["grass"] = ownerSchema<GrassSettings>();
  properties["bezier"] = ownerSchema<BezierSettings>();
  properties["shell"] = ownerSchema<ShellSettings>();
  properties["species"] = listOf(ownerSchema<Species>(), kMaxSpecies);
  properties["colliders"] = listOf(colliderSchema(), kMaxColliders);
  properties["surfaces"] = listOf(ownerSchema<Surface>(), kMaxSurfaces);
  properties["rotors"] = listOf(ownerSchema<Rotor>(), kMaxRotors);
  properties["probes"] = listOf(ownerSchema<Probe>(), kMaxProbes);
  properties["cameras"] = listOf(ownerSchema<Camera>(), kMaxCameras);
  const Schema schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                      {"title", "Windloom project"},
                      {"description", "NAME.wind.json; written by 'windloom docs' from the parameter tables."},
                      {"type", "object"},
                      {"properties", std::move(properties)},
                      {"required", {"format", "version"}}};
  return schema.dump(1) + "\n";
}

std::string parametersMarkdown() {
  std::string text =
      "# Parameters\n"
      "Every value of a project file (NAME.wind.json), in the order of the file. Made by `windloom docs docs` from "
      "the\n"
      "tables in engine/model/parameters*.cpp. A `/` in a key stands for an object in an object; ranges hold for each\n"
      "component. Missing keys take their default; unknown keys are kept and reported.\n";
  appendTable<FieldSettings>(text, "Field", "/field");
  appendTable<SolverSettings>(text, "Solver", "/solver");
  appendTable<AmbientWind>(text, "Ambient wind", "/ambient");
  appendTable<Point>(text, "Point", "/graph/points/N");
  appendTable<Arrow>(text, "Arrow", "/graph/arrows/N");
  appendTable<Signal>(text, "Signal", "/graph/signals/N");
  text += "| keys |  |  | [0 to " + shortest(kMaxSignalKeyTimeS) + " s, 0 to " + shortest(kMaxSignalKeyValue) +
          "] |  | Time, factor on the strength, and how the curve goes on to the next key: linear (left out in files), "
          "smooth, hold. Times ascend; curve. |\n";
  appendTable<Obstacle>(text, "Obstacle", "/obstacles/N");
  text += "| points |  | m | " + std::to_string(kMinCorners) + " to " + std::to_string(kMaxCorners) + " of [-" +
          shortest(kMaxCornerM) + " to " + shortest(kMaxCornerM) + ", the same] |  | Corners (x, z) from the centre " +
          "along its own axes, in order around; sides don't cross; polygon. |\n";
  appendTable<TerrainSettings>(text, "Terrain", "/terrain");
  appendTable<GrassSettings>(text, "Grass", "/grass");
  appendTable<BezierSettings>(text, "Bezier grass", "/bezier");
  appendTable<ShellSettings>(text, "Shell grass", "/shell");
  appendTable<Species>(text, "Species", "/species/N");
  appendTable<Collider>(text, "Collider", "/colliders/N");
  const std::string reach = shortest(kMaxColliderOffsetM);
  text += "| keys |  |  | [0 to " + shortest(kMaxColliderKeyTimeS) + " s, three of -" + reach + " to " + reach +
          " m] |  | Time, and how far it is from its place then: x, height over the ground, z. Times ascend. |\n";
  appendTable<Surface>(text, "Surface", "/surfaces/N");
  appendTable<Rotor>(text, "Rotor", "/rotors/N");
  appendTable<Probe>(text, "Probe", "/probes/N");
  appendTable<Camera>(text, "Camera", "/cameras/N");
  return text;
}

}  // namespace windloom
