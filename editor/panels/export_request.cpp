#include "editor/panels/export_request.hpp"

#include <algorithm>
#include <cmath>

#include "editor/core/size_text.hpp"
#include "engine/bake/response.hpp"

namespace windloom::editor {
namespace fs = std::filesystem;

BakeRequest bakeRequest(const ExportChoices& choices, const Project& project) {
  BakeRequest request;
  for (const WriterKind& kind : writerKinds())
    if (choices.formats.contains(kind.name) && kind.missing.empty()) request.formats.push_back(&kind);
  request.plan.from = choices.from;
  request.plan.fps = choices.fps;
  request.plan.frames = std::clamp(static_cast<int>(std::lround(choices.seconds * choices.fps)), 1, kMaxBakeFrames);
  request.loop = choices.loop;
  if (choices.loop) request.plan.crossfade = crossfadeFor(request.plan.frames);
  if (choices.ownResolution && choices.resolution != project.field->resolution) request.resolution = choices.resolution;
  if (choices.ownFullScale) request.fullScale = static_cast<float>(choices.fullScale);
  request.preset = presetNamed(choices.preset).value_or(Preset::Generic);
  request.space = choices.uvFlow ? FlowSpace::Uv : FlowSpace::World;
  request.profile = {.layers = choices.layers,
                     .top = static_cast<float>(choices.top),
                     .reference = static_cast<float>(choices.reference),
                     .roughness = static_cast<float>(choices.roughness)};
  request.response = choices.response;
  request.graph = choices.graph;
  request.sidecars = choices.sidecars;
  return request;
}

std::vector<std::string_view> proposedFormats(Preset preset) {
  std::vector<std::string_view> names;
  switch (preset) {
    case Preset::Unreal:
      names = {"exr", "fga"};
      break;
    case Preset::Unity:
    case Preset::UnityNegZ:
      names = {"exr", "vf"};
      break;
    case Preset::Godot:
      names = {"exr", "dds", "godot-slab"};
      break;
    case Preset::Generic:
      names = {"exr", "windpack"};
      break;
  }
  std::erase_if(names, [](std::string_view name) {
    const WriterKind* kind = writerKindNamed(name);
    return kind == nullptr || !kind->missing.empty();
  });
  return names;
}

std::vector<std::string_view> formatGroups() {
  std::vector<std::string_view> groups = {"Images", "Textures", "Volumes", "Data"};
  for (const WriterKind& kind : writerKinds())
    if (std::ranges::find(groups, kind.group) == groups.end()) groups.push_back(kind.group);
  return groups;
}

ExportSize sizeOf(const WriterKind& kind, const BakeHeader& header, const BakeRequest& request) {
  const std::size_t tracks = request.response ? 1 + plantClasses().size() : 1;
  return {static_cast<double>(kind.bytes(header)) * static_cast<double>(tracks), kind.exactSize};
}

ExportSize sizeOf(const BakeHeader& header, const BakeRequest& request) {
  ExportSize all;
  for (const WriterKind* kind : request.formats) {
    const ExportSize size = sizeOf(*kind, header, request);
    all.bytes += size.bytes;
    all.exact = all.exact && size.exact;
  }
  return all;
}

std::string sizeText(const ExportSize& size) {
  const std::string text = bytesText(size.bytes);
  return size.exact ? text : "about " + text;
}

std::vector<std::string> warningsOf(const BakeHeader& header, const BakeRequest& request) {
  std::vector<std::string> warnings;
  for (const WriterKind* kind : request.formats) {
    const std::string warning = kind->warning != nullptr ? kind->warning(header) : std::string();
    if (!warning.empty()) warnings.push_back(std::string(kind->name) + ": " + warning);
  }
  return warnings;
}

bool hasVolume(const BakeRequest& request) {
  return std::ranges::any_of(request.formats, [](const WriterKind* kind) { return kind->group == "Volumes"; });
}

bool hasFullScale(const BakeRequest& request) {
  return std::ranges::any_of(request.formats, [](const WriterKind* kind) { return kind->need == SpeedNeed::Range; });
}

std::optional<double> FreeSpace::of(const fs::path& folder) {
  constexpr auto kFresh = std::chrono::seconds(3);
  const auto now = std::chrono::steady_clock::now();
  if (folder == m_folder && now - m_at < kFresh) return m_bytes;
  m_folder = folder;
  m_at = now;
  m_bytes.reset();
  std::error_code failed;
  fs::path there = fs::absolute(folder, failed);
  if (failed) return m_bytes;
  // The folder itself is made by the export.
  while (!fs::exists(there, failed) && there.has_relative_path()) there = there.parent_path();
  const fs::space_info space = fs::space(there, failed);
  if (!failed) m_bytes = static_cast<double>(space.available);
  return m_bytes;
}

}  // namespace windloom::editor
