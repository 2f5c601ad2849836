#include "engine/cli/limits_page.hpp"

#include <cstdint>
#include <span>

#include "engine/bake/atlas_layout.hpp"
#include "engine/bake/bake.hpp"
#include "engine/bake/dds_header.hpp"
#include "engine/bake/live_link.hpp"
#include "engine/bake/manifest.hpp"
#include "engine/bake/voxel_field.hpp"
#include "engine/cli/option_limits.hpp"
#include "engine/core/text.hpp"
#include "engine/grass/bezier_placement.hpp"
#include "engine/io/assets.hpp"
#include "engine/io/file_limits.hpp"
#include "engine/io/gltf_limits.hpp"
#include "engine/io/image.hpp"
#include "engine/io/json_document.hpp"
#include "engine/io/plant_file.hpp"
#include "engine/io/project_json.hpp"
#include "engine/io/terrain_file.hpp"
#include "engine/model/height_field.hpp"
#include "engine/model/outline.hpp"
#include "engine/model/parameter.hpp"
#include "engine/model/plant_mesh.hpp"
#include "engine/model/sphere_packing.hpp"
#include "engine/model/validate.hpp"
#include "engine/runtime/windpack_format.h"
#include "engine/session/simulation.hpp"

namespace windloom::cli {
namespace {

struct Row {
  const char* what;
  std::string value;
  const char* where;  // file of the code that checks it
  const char* why;
};

/// "100 000"
std::string count(std::uint64_t number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ' ';
    text += digits[i];
  }
  return text;
}

std::string mebibytes(std::uint64_t bytes) {
  return count(bytes >> 20) + " MiB";
}

std::string table(const char* title, std::span<const Row> rows) {
  std::string text = std::string("\n## ") + title + "\n\n| limit | value | checked in | why |\n|---|---|---|---|\n";
  for (const Row& row : rows)
    text += std::string("| ") + row.what + " | " + row.value + " | `" + row.where + "` | " + row.why + " |\n";
  return text;
}

std::string projectRows() {
  const char* validate = "engine/model/validate.cpp";
  const char* json = "engine/io/json_document.cpp";
  const Row rows[] = {
      {"size of a project file", mebibytes(kMaxProjectBytes), "engine/io/project_reader.cpp",
       "ten times the greatest project within the counts below"},
      {"nesting of JSON", count(kMaxJsonDepth) + " levels", json, "a project needs 7; deeper text could end a stack"},
      {"keys of a JSON object", count(kMaxJsonKeys), json, "each new key is compared with all before it"},
      {"values of a JSON document", count(kMaxJsonValues), json, "each takes 16 bytes and more"},
      {"length of a name", count(kMaxTextBytes) + " bytes", "engine/model/parameter.cpp", "one line on the screen"},
      {"points, and signals", count(kMaxPoints), validate, "a hundred times what a person draws"},
      {"arrows", count(kMaxArrows), validate, "as points"},
      {"keys of a signal", count(kMaxSignalKeys), validate, "an hour at three a second"},
      {"obstacles", count(kMaxObstacles), validate, "each is drawn into the wind's grid"},
      {"corners of an outline", count(kMaxCorners), "engine/model/outline.cpp",
       "crossings are looked for among all pairs of sides"},
      {"species", count(kMaxSpecies), validate, "each is a draw of its own"},
      {"colliders", count(kMaxColliders), validate, "every blade near one asks all of them"},
      {"spheres of a collider", count(kMaxSpheres), "engine/model/sphere_packing.cpp", "the same"},
      {"keys of a collider", count(kMaxColliderKeys), validate, "as those of a signal"},
      {"surfaces", count(kMaxSurfaces), validate, "each has textures of its own"},
      {"rotors", count(kMaxRotors), validate, "each adds to every step of the wind"},
      {"probes", count(kMaxProbes), validate, "each keeps its values"},
      {"cameras", count(kMaxCameras), validate, "rows of a menu"},
      {"blades: density x field", count(static_cast<std::uint64_t>(kMaxBlades)), validate,
       "what the instanced grass can count"},
      {"blades of Bezier grass that are kept", count(kMaxBezierBlades), "engine/grass/bezier_placement.cpp",
       "denser meadows are thinned, not refused"},
      {"checkpoints of the timeline", mebibytes(SimulationOptions{}.checkpointBytes), "engine/session/checkpoints.cpp",
       "the oldest are thinned out, nothing is refused"},
  };
  return table("Projects", rows);
}

std::string assetRows() {
  const char* image = "engine/io/image.cpp";
  const char* gltf = "engine/io/gltf_file.cpp";
  const Row rows[] = {
      {"size of a picture, mesh or height file", mebibytes(kMaxTerrainBytes), "engine/core/file.cpp",
       "it is read as a whole"},
      {"size of a PNG file", mebibytes(kMaxPngBytes), image, "the greatest picture below, packed by half"},
      {"side of a PNG picture", count(kMaxImageSide) + " pixels", image, "what graphics cards take"},
      {"pixels of a PNG picture", count(kMaxImagePixels), image, "1 GiB of 16-bit RGBA"},
      {"texts, profiles and all else of a PNG picture that makes no pixels", "passed over", image,
       "a few kilobytes could unpack to gigabytes"},
      {"height map", count(kMaxTerrainPicture) + " pixels a side", "engine/io/terrain_file.cpp", "as above"},
      {"samples that are kept of it", count(kMaxHeightSamples) + " a side", "engine/io/terrain_file.cpp",
       "larger ones are averaged, not refused"},
      {"map of the grass, shell picture", count(kMaxGrassMap) + " pixels a side are kept", "engine/io/assets.cpp",
       "larger ones are averaged, not refused"},
      {"values in the JSON of a glTF file", count(gltf::kMaxValues), gltf,
       "bounds nodes, meshes, accessors, buffers, materials and data URIs together"},
      {"nesting of it", count(kMaxJsonDepth) + " levels", gltf, "its library follows it by recursion"},
      {"other files of a glTF file together", mebibytes(gltf::kMaxBufferBytes), gltf, "all are held at once"},
      {"other files of a glTF file", count(gltf::kMaxFiles), gltf, "each is looked up, opened and copied along"},
      {"pieces of meshes that its nodes place", count(gltf::kMaxPlacedPrimitives), gltf, "a node may repeat a mesh"},
      {"vertices and triangles of a terrain", count(kMaxTerrainVertices), "engine/io/terrain_mesh.cpp",
       "half a gigabyte; the heights made of it are far fewer"},
      {"samples that its triangles are drawn over", count(kMaxDrawnSamples), "engine/io/terrain_mesh.cpp",
       "ground needs ten times fewer; triangles in a pile could take days"},
      {"triangles of a plant", count(kMaxPlantTriangles), "engine/io/plant_file.cpp",
       "a meadow draws it thousands of times"},
      {"triangles of a collider's mesh", count(kMaxObjectTriangles), "engine/io/plant_file.cpp", "spheres fill it"},
      {"rays and points that fill it with spheres", count(kMostPackingWork), "engine/model/sphere_packing.cpp",
       "for more it is cut into larger voxels, not refused"},
      {"triangles of a surface's mesh", count(kMaxSurfaceTriangles), "engine/io/plant_file.cpp",
       "every frame draws them all"},
      {"triangles of all meshes of a project", count(kMaxProjectTriangles), "engine/io/assets.cpp",
       "about 3 GB with their vertices"},
      {"materials of a plant", count(gltf::kMaxMaterials), "engine/io/plant_texture.cpp",
       "their pictures are stacked into one"},
      {"side of a plant's picture", count(gltf::kMaxPictureSide) + " pixels", "engine/io/plant_texture.cpp",
       "what artists paint"},
      {"scans of a JPEG picture", count(gltf::kMaxJpegScans), "engine/io/plant_texture.cpp",
       "progressive ones have about ten; each passes over all pixels"},
      {"pixels of all pictures of a plant", count(gltf::kMaxPicturePixels), "engine/io/plant_texture.cpp",
       "512 MiB while they are stacked"},
      {"side of the picture kept of them", count(kMaxPlantTexture) + " pixels", "engine/io/plant_texture.cpp",
       "larger ones are averaged, not refused"},
      {"size of a .npy file", mebibytes(kMaxNpyBytes), "engine/io/npy.cpp", "a field of 8192 x 8192 cells, twice over"},
      {"axes of a .npy file", "32", "engine/io/npy.cpp", "NumPy's own limit"},
  };
  return table("Files that a project names, and --initial", rows);
}

std::string bakeRows() {
  const char* runtime = "engine/runtime/header.c";
  const char* verb = "engine/cli/verb_bake.cpp";
  const Row rows[] = {
      {"frames of a bake", count(kMaxBakeFrames), verb, "an hour at 27 a second"},
      {"--resolution of a bake", count(kMaxBakeSide) + " cells a side", verb, "that of wind packs"},
      {"frames x cells of a bake", count(kMaxBakeCells), "engine/bake/bake.cpp",
       "2 TiB of wind; the free space of the disk is asked, too, where the size is known before"},
      {"--seconds, --from, --time, --warm-up", count(static_cast<std::uint64_t>(kMaxSeconds)) + " s", verb,
       "eleven days of wind"},
      {"--steps", count(kMaxSteps), verb, "the same in steps"},
      {"--layers of volumes", count(kMaxBakeLayers), verb, "engines' volume textures"},
      {"side of an atlas", count(kMaxAtlasSide) + " pixels", "engine/bake/atlas_layout.cpp", "what engines import"},
      {"slices of a DDS or KTX2 file", count(kMaxTextureSlices), "engine/bake/dds_header.cpp",
       "what graphics cards take"},
      {"voxels of a volume", count(kMostVoxels), "engine/bake/voxel_field.cpp", "512 MiB in single precision"},
      {"manifest.json and notes of parts read back", mebibytes(kMaxManifestBytes), "engine/bake/manifest.cpp",
       "the greatest that a bake writes"},
      {"cells of the live link", count(LiveLink::kMaxSide) + " a side", "engine/bake/live_link.cpp",
       "finer winds are averaged, not refused"},
      {"sides of a wind pack", count(WINDPACK_MAX_SIDE) + " cells", runtime, "its index is 32 bits wide"},
      {"frames of a wind pack", count(WINDPACK_MAX_FRAMES), runtime, "as of a bake"},
      {"data of a wind pack, unpacked", mebibytes(WINDPACK_MAX_DATA_BYTES), runtime, "a game loads it into memory"},
      {"--size of a picture", count(kMaxRenderSide) + " pixels a side", "engine/cli/verb_render.cpp",
       "what graphics cards take"},
      {"--frames of pictures", count(kMaxRenderFrames), "engine/cli/verb_render.cpp", "as of a bake"},
      {"--resolution for a picture", count(kMaxRenderCells) + " cells a side", "engine/cli/verb_render.cpp",
       "the greatest field of a project"},
      {"--size of benchmarks' pictures", count(kMaxBenchPictureSide) + " pixels a side", "engine/cli/verb_bench.cpp",
       "twice that is drawn"},
  };
  return table("Bakes, wind packs and pictures", rows);
}

// The editor's constants can't be seen from here; a test of the editor compares these with them.
std::string editorRows() {
  const Row rows[] = {
      {"size of the preferences", "4 MiB", "editor/core/preferences.cpp", "they have a few kilobytes"},
      {"recent files", "12", "editor/core/preferences.cpp", "rows of a menu"},
      {"folders whose projects may read files elsewhere", "200", "editor/core/preferences.cpp",
       "the oldest are forgotten"},
      {"size of a rescue file", "256 MiB", "editor/core/autosave.cpp", "a project, escaped as a text"},
      {"text that is pasted", mebibytes(kMaxProjectBytes), "engine/io/project_reader.cpp", "it is a project"},
      {"nesting, keys and values of all of these", "as of a project", "engine/io/json_document.cpp", "the same reader"},
  };
  return table("The editor's own files", rows);
}

}  // namespace

std::string limitsMarkdown() {
  return "# Limits\n\nWritten by `windloom docs docs` from the constants of the code.\n\n"
         "Every count and size that a file or an option can name has a limit, checked before memory is taken or work "
         "is "
         "begun. A file that is over one is refused with its place and what was expected (exit status 1, for options "
         "2). "
         "Ranges of single values, such as the resolution of the wind (8 to 4096 cells a side), are in "
         "[parameters.md](parameters.md).\n\n"
         "Only regular files are read: a folder, a pipe, a device or a socket in the place of one is refused at once, "
         "and "
         "a file that is too large before it is read. Files outside a project's folder, by `..`, by an absolute path "
         "or "
         "through a link, are not read unless the user allows it: `--allow-outside`, or the question that the editor "
         "asks; no copy is ever written there. Nothing that a file names is ever fetched from a network or "
         "executed.\n\n"
         "Within the limits a project can still need more memory than a machine has. Then the command line ends with "
         "exit status 3 and says so; the editor says so and keeps the document.\n" +
         projectRows() + assetRows() + bakeRows() + editorRows();
}

}  // namespace windloom::cli
