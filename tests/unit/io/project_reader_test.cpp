#include <gtest/gtest.h>

#include "tests/unit/io/project_fixture.hpp"

namespace windloom {
namespace {

using Pointers = std::vector<std::string>;

std::string messageOf(const std::string& name) {
  const Result<LoadedProject> loaded = loadProject(brokenFile(name));
  EXPECT_TRUE(!loaded.ok() || !loaded->missing.empty()) << name;
  std::string text;
  for (const Problem& problem : loaded ? loaded->missing : loaded.error().problems) text += problem.text();
  return text;
}

}  // namespace

TEST(ProjectJson, ReadsEveryKindOfRecord) {
  const Result<LoadedProject> loaded = parseProject(kRichProject, "rich");
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  const Project& project = loaded->project;
  EXPECT_EQ(project.name, "Rich \"meadow\" \xc3\xbc");
  EXPECT_EQ(project.field->size, glm::vec2(50, 25));
  EXPECT_EQ(project.field->resolution, glm::ivec2(100, 50));
  EXPECT_EQ(project.field->xMax, Border::Periodic);
  EXPECT_EQ(project.field->zMin, Border::Wall);
  EXPECT_EQ(project.solver->backend, Backend::Cpu);
  EXPECT_EQ(project.ambient->gustStrength, 0.3f);
  EXPECT_EQ(project.graph->points[1].position, glm::vec2(0.1f, 5));
  EXPECT_EQ(project.graph->arrows[0].swirl, -1.5f);
  EXPECT_TRUE(project.graph->arrows[1].muted);
  EXPECT_EQ(project.graph->signals[0].kind, SignalKind::Curve);
  ASSERT_EQ(project.graph->signals[0].keys.size(), 3u);
  EXPECT_EQ(project.graph->signals[0].keys[1].time, 1.25f);
  EXPECT_EQ(project.obstacles->at(0).shape, ObstacleShape::Box);
  EXPECT_EQ(project.grass->shadowMin, 0.5f);
  EXPECT_EQ(project.grass->densityMap, "assets/mask.png");
  EXPECT_EQ(project.species->at(0).shape, PlantShape::Daisy);
  EXPECT_EQ(project.species->at(0).tipColour, glm::vec3(1, 1, 0.9f));
  EXPECT_EQ(project.species->at(1).file, "assets/tuft.glb");
  EXPECT_EQ(project.colliders->at(0).position, glm::vec2(2, 3));
  EXPECT_EQ(project.colliders->at(0).keys, (std::vector<ColliderKey>{{0, {0, 0, 0}}, {1.5f, {4, 0.25f, -2}}}));
  EXPECT_EQ(project.colliders->at(1).shape, ColliderShape::Mesh);
  EXPECT_EQ(project.bezier->tufts, 0.6f);
  EXPECT_EQ(project.bezier->form, BladeForm::Quadratic);
  EXPECT_EQ(project.bezier->wind, BezierWind::Both);
  EXPECT_EQ(project.bezier->gravityDirection, glm::vec3(0, -2, 0.5f));
  EXPECT_EQ(project.bezier->collisionFade, 0.2f);
  EXPECT_EQ(project.shell->shells, 12);
  EXPECT_EQ(project.shell->method, ShellMethod::Plain);
  EXPECT_EQ(project.shell->tile, 2.5f);
  EXPECT_EQ(project.shell->texture, "assets/blades.png");
  EXPECT_EQ(project.shell->stiffnessCurve, 0.7f);
  EXPECT_EQ(project.shell->wind, ShellWind::Both);
  EXPECT_EQ(project.shell->sampling, ShellSampling::Texel);
  EXPECT_EQ(project.shell->source, glm::vec2(3, -4));
  EXPECT_EQ(project.surfaces->at(0).shape, SurfaceShape::Moebius);
  EXPECT_TRUE(project.surfaces->at(0).bothSides);
  EXPECT_EQ(project.surfaces->at(1).file, "assets/stone.glb");
  EXPECT_EQ(project.rotors->at(0).position, glm::vec2(-3, 1));
  EXPECT_EQ(project.rotors->at(0).rings, 0.8f);
  EXPECT_EQ(project.probes->at(0).id, 40u);
  EXPECT_EQ(project.cameras->at(0).position, glm::vec3(0, 2, 9));
}

TEST(ProjectJson, MissingKeysTakeTheirDefault) {
  const Result<LoadedProject> loaded = parseProject(R"({"format": "windloom-project", "version": 1})", "small");
  ASSERT_TRUE(loaded.ok());
  EXPECT_TRUE(loaded->warnings.empty());
  EXPECT_EQ(loaded->project.field->resolution, glm::ivec2(1000, 1000));
  EXPECT_EQ(loaded->project.solver->seed, 7);
  EXPECT_TRUE(loaded->project.graph->points.empty());
}

TEST(ProjectJson, ReportsUnknownKeysAtTheirPlace) {
  const Result<LoadedProject> loaded = parseProject(kRichProject, "rich");
  ASSERT_TRUE(loaded.ok());
  Pointers pointers;
  for (const Problem& warning : loaded->warnings) {
    EXPECT_EQ(warning.file, "rich");
    pointers.push_back(warning.pointer);
  }
  EXPECT_EQ(pointers, (Pointers{"/field/later", "/field/borders/floor", "/ambient/gusts/colour", "/graph/points/1/tag",
                                "/graph/layers", "/grass/maps/wet", "/bezier/tufts/moss", "/bezier/dew",
                                "/shell/texture/ply", "/shell/mow", "/species/1/season", "/colliders/0/mass",
                                "/surfaces/1/grain", "/rotors/0/noise", "/studio"}));
}

TEST(ProjectJson, EscapesKeysInPointers) {
  const Result<LoadedProject> loaded = parseProject(
      R"({"format": "windloom-project", "version": 1, "a/b~c": 1, "ambient": {"gusts/strength": 1}})", "x");
  ASSERT_TRUE(loaded.ok());
  ASSERT_EQ(loaded->warnings.size(), 2u);
  EXPECT_EQ(loaded->warnings[0].pointer, "/a~1b~0c");
  EXPECT_EQ(loaded->warnings[1].pointer, "/ambient/gusts~1strength");
}

TEST(ProjectJson, CollectsAllProblemsWithPlaceAndExpectation) {
  const Result<LoadedProject> loaded = loadProject(brokenFile("wrong-types"));
  EXPECT_EQ(problemPointers(loaded), (Pointers{"/field", "/graph/arrows/0/drive", "/graph/arrows/0/id",
                                               "/graph/arrows/0/muted", "/graph/arrows/0/radius"}));
  const std::string text = loaded.error().text();
  for (const char* part :
       {"found \"wide\", expected a number from 0.05 to 1000 (m)", "found 3, expected one of speed, force",
        "found 1, expected true or false", "found \"eleven\", expected an id", "expected an object"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
}

TEST(ProjectJson, CollectsSyntacticAndSemanticProblemsTogether) {
  const Result<LoadedProject> loaded = parseProject(
      R"({"format": "windloom-project", "version": 1, "field": {"timeStep": 9}, "grass": {"height": -1},
          "graph": {"points": [{"id": 1, "position": [0, 0]}], "arrows": [{"id": 5, "from": 1, "to": 3}]}})",
      "x");
  EXPECT_EQ(problemPointers(loaded), (Pointers{"/field/timeStep", "/graph/arrows/0/to", "/grass/height"}));
}

TEST(ProjectJson, DoesNotBlameArrowsForABrokenPoint) {
  EXPECT_EQ(problemPointers(loadProject(brokenFile("missing-id"))), Pointers{"/graph/points/0/id"});
  EXPECT_EQ(problemPointers(loadProject(brokenFile("null-position"))), Pointers{"/graph/points/0/position"});
}

TEST(ProjectJson, NamesThePlaceOfEachRefusal) {
  const std::pair<const char*, const char*> expected[] = {
      {"array", ""},
      {"bezier-without-gravity", "/bezier/gravity/direction"},
      {"beyond-float", "/graph/points/0/position"},
      {"collider-key-backwards", "/colliders/0/keys/2"},
      {"collider-key-short", "/colliders/0/keys/1"},
      {"collider-mesh-without-file", "/colliders/0/file"},
      {"control-character-name", "/name"},
      {"dangling-arrow", "/graph/arrows/0/to"},
      {"dangling-signal", "/graph/signals/0/root"},
      {"duplicate-ids", "/graph/points/2/id"},
      {"duplicate-key", "/graph/arrows/0/radius"},
      {"empty", ""},
      {"id-of-point-and-arrow", "/graph/arrows/0/id"},
      {"id-of-species-and-collider", "/colliders/0/id"},
      {"id-of-surface-and-rotor", "/rotors/0/id"},
      {"keys-not-ascending", "/graph/signals/0/keys/1"},
      {"map-outside", "/grass/maps/density"},
      {"missing-format", "/format"},
      {"missing-version", "/version"},
      {"nan", "line 7, column 30"},
      {"nan-text", "/graph/points/0/position"},
      {"negative-radius", "/graph/arrows/0/radius"},
      {"newer-version", "/version"},
      {"not-json", "line 1, column 1"},
      {"number-too-large", "line 7, column 34"},
      {"periodic-alone", "/field/borders/xMax"},
      {"resolution-fraction", "/field/resolution"},
      {"resolution-huge", "/field/resolution"},
      {"resolution-zero", "/field/resolution"},
      {"self-arrow", "/graph/arrows/0/to"},
      {"shell-over-bend", "/shell/bend/overBend"},
      {"shell-picture-outside", "/shell/texture/file"},
      {"species-mesh-outside", "/species/0/file"},
      {"species-unknown-shape", "/species/0/shape"},
      {"too-many-blades", "/grass/density"},
      {"too-many-species", "/species"},
      {"twin-arrows", "/graph/arrows/1"},
      {"unknown-choice", "/graph/arrows/0/drive"},
      {"wrong-format", "/format"},
      {"zero-length-arrow", "/graph/arrows/0"},
  };
  for (const auto& [name, pointer] : expected) {
    EXPECT_EQ(problemPointers(loadProject(brokenFile(name))), Pointers{pointer}) << name << ": " << messageOf(name);
    EXPECT_NE(messageOf(name).find(name), std::string::npos) << "the message names the file";
  }
}

TEST(ProjectJson, NamesThePlaceOfAKeysWrongPart) {
  const auto refusal = [](const std::string& key) {
    const Result<LoadedProject> loaded = parseProject(
        R"({"format": "windloom-project", "version": 1, "graph": {"points": [{"id": 1, "position": [0, 0]}],
            "signals": [{"root": 1, "kind": "curve", "keys": [[0, 1, "hold"], )" +
            key + "]}]}}",
        "x");
    return loaded.ok() ? "taken" : loaded.error().text();
  };
  EXPECT_EQ(refusal(R"([1, 2, "smooth"])"), "taken");
  EXPECT_EQ(refusal(R"([1, 2, "linear"])"), "taken");
  for (const auto& [key, told] :
       {std::pair{R"([1, 2, "bouncy"])", "/keys/1/2: found \"bouncy\", expected one of linear"},
        {"[1, 2, 3]", "/keys/1/2: found 3, expected one of linear, smooth, hold"},
        {"[1]", "/keys/1: found"},
        {R"(["1", 2])", "/keys/1: found"},
        {R"([1, 2, "hold", 4])", "/keys/1: found"},
        {"[1, 9]", "/keys/1: "}}) {
    EXPECT_NE(refusal(key).find(std::string("/graph/signals/0") + told), std::string::npos) << refusal(key);
  }
}

TEST(ProjectJson, NamesThePlaceOfAColliderKeysWrongPart) {
  const auto refusal = [](const std::string& keys) {
    const Result<LoadedProject> loaded = parseProject(
        R"({"format": "windloom-project", "version": 1, "colliders": [{"id": 1, "keys": )" + keys + "}]}", "x");
    if (loaded.ok()) return std::string("taken");
    EXPECT_EQ(loaded.error().problems.size(), 1u) << loaded.error().text();
    return loaded.error().text();
  };
  EXPECT_EQ(refusal("[]"), "taken");
  EXPECT_EQ(refusal("[[0, 1, 2, 3], [0.5, -1, 0, 1e3]]"), "taken");
  for (const auto& [keys, told] :
       {std::pair{"{}", "/keys: found {}, expected an array of at most 10000 keys [time, x, height, z]"},
        {"[[0, 0, 0, 0], [1, 2, 3]]", "/keys/1: found [1,2,3], expected four numbers [time, x, height, z]"},
        {"[[0, 0, 0, 0, 0], [5, 0, 0, 0], [1, 0, 0, 0]]", "/keys/0: found"},
        {R"([[0, 0, "high", 0]])", "/keys/0: found"},
        {"[7]", "/keys/0: found 7"},
        {"[[-1, 0, 0, 0]]", "/keys/0: its time is out of range"},
        {"[[0, 1e7, 0, 0]]", "/keys/0: its offset is out of range"},
        {"[[2, 0, 0, 0], [2, 1, 0, 0]]", "/keys/1: is not later than the key before it"}}) {
    EXPECT_NE(refusal(keys).find(std::string("/colliders/0") + told), std::string::npos) << refusal(keys);
  }
}

TEST(ProjectJson, ReadsCollidersAndSpeciesWithNothingButTheirId) {
  const Result<LoadedProject> loaded = parseProject(
      R"({"format": "windloom-project", "version": 1, "species": [{"id": 1}], "colliders": [{"id": 2}]})", "x");
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  Species species;
  species.id = 1;
  Collider collider;
  collider.id = 2;
  EXPECT_EQ(loaded->project.species->at(0), species);
  EXPECT_EQ(loaded->project.colliders->at(0), collider);
  EXPECT_EQ(
      problemPointers(parseProject(
          R"({"format": "windloom-project", "version": 1, "species": [{}], "colliders": [{"radius": 2}, 3]})", "x")),
      (Pointers{"/colliders/0/id", "/colliders/1", "/colliders/1/id", "/species/0/id"}));
}

TEST(ProjectJson, ReadsSurfacesAndRotorsWithNothingButTheirId) {
  const Result<LoadedProject> loaded = parseProject(
      R"({"format": "windloom-project", "version": 1, "surfaces": [{"id": 1}], "rotors": [{"id": 2}]})", "x");
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  Surface surface;
  surface.id = 1;
  Rotor rotor;
  rotor.id = 2;
  EXPECT_EQ(loaded->project.surfaces->at(0), surface);
  EXPECT_EQ(loaded->project.rotors->at(0), rotor);
  EXPECT_EQ(problemPointers(parseProject(
                R"({"format": "windloom-project", "version": 1, "surfaces": [{}, 3], "rotors": {"id": 2}})", "x")),
            (Pointers{"/rotors", "/surfaces/0/id", "/surfaces/1", "/surfaces/1/id"}));
}

TEST(ProjectJson, SyntaxErrorsSayThatItIsNoJson) {
  for (const char* name : {"binary", "nan", "not-json", "not-utf8", "number-too-large", "truncated"}) {
    EXPECT_NE(messageOf(name).find("is not valid JSON: "), std::string::npos) << messageOf(name);
    EXPECT_NE(messageOf(name).find("line "), std::string::npos) << messageOf(name);
  }
}

TEST(ProjectJson, NewerVersionNamesBothVersions) {
  const std::string message = messageOf("newer-version");
  EXPECT_NE(message.find("version 99"), std::string::npos) << message;
  EXPECT_NE(message.find("version " + std::to_string(kProjectVersion)), std::string::npos) << message;
}

TEST(ProjectJson, RefusesAMissingFileAndAFolder) {
  const Result<LoadedProject> missing = loadProject(brokenFile("no-such-file"));
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().kind, ErrorKind::BadInput);
  EXPECT_EQ(missing.error().problems[0].file, brokenFile("no-such-file"));
  EXPECT_FALSE(loadProject(WINDLOOM_TEST_DATA).ok());
}

TEST(ProjectJson, RefusesMoreRecordsThanThereMayBeBeforeReadingThem) {
  std::string text = R"({"format": "windloom-project", "version": 1, "probes": [0)";
  for (int i = 0; i < 1000; ++i) text += ",0";
  EXPECT_EQ(problemPointers(parseProject(text + "]}", "x")), Pointers{"/probes"});
}

TEST(ProjectJson, TakesWholeNumbersWrittenWithAPoint) {
  const Result<LoadedProject> loaded =
      parseProject(R"({"format": "windloom-project", "version": 1.0, "field": {"resolution": [64.0, 1e2]}})", "x");
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  EXPECT_EQ(loaded->project.field->resolution, glm::ivec2(64, 100));
}

TEST(ProjectJson, TakesAByteOrderMark) {
  EXPECT_TRUE(parseProject("\xef\xbb\xbf{\"format\": \"windloom-project\", \"version\": 1}", "x").ok());
}

}  // namespace windloom
