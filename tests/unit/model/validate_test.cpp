#include "engine/model/validate.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "engine/model/parameters.hpp"
#include "tests/unit/model/model_fixture.hpp"

namespace windloom {
namespace {

std::vector<Problem> problemsOf(WindGraph graph) {
  return validate(projectOf(std::move(graph)));
}

template <class Owner>
void expectLegalDefaults() {
  const Owner owner{};
  for (const Parameter<Owner>& parameter : parametersOf<Owner>()) {
    if (parameter.info.type == ParameterType::Id) continue;  // 0 stands for none until a project gives one
    EXPECT_EQ(parameterProblem(parameter.info, parameter.get(owner)), "") << parameter.info.key;
    EXPECT_FALSE(parameter.info.help.empty()) << parameter.info.key;
  }
}

using Pointers = std::vector<std::string>;

Pointers pointersOf(const Project& project) {
  Pointers pointers;
  for (const Problem& problem : validate(project)) {
    EXPECT_FALSE(problem.message.empty()) << problem.pointer;
    pointers.push_back(problem.pointer);
  }
  return pointers;
}

template <class Part>
Shared<Part> changed(const Shared<Part>& part, auto&& change) {
  auto copy = std::make_shared<Part>(*part);
  change(*copy);
  return copy;
}

Project withGraph(auto&& change) {
  Project project = projectOf(line());
  project.graph = changed(project.graph, change);
  return project;
}

}  // namespace

TEST(Validate, TakesTheDefaultsAndASmallTree) {
  EXPECT_TRUE(validate(Project{}).empty());
  EXPECT_TRUE(problemsOf(smallTree()).empty());
}

TEST(Validate, NamesDanglingAndDuplicateIds) {
  WindGraph graph = smallTree();
  graph.arrows[1].to = 99;
  graph.points[3].id = 1;
  const std::vector<Problem> problems = problemsOf(graph);
  EXPECT_TRUE(hasProblem(problems, "/graph/arrows/1/to"));
  EXPECT_TRUE(hasProblem(problems, "/graph/points/3/id"));
}

TEST(Validate, NamesArrowsWithoutLengthAndTwins) {
  WindGraph graph = smallTree();
  graph.points[2].position = graph.points[1].position;
  graph.arrows.push_back(arrowBetween(13, 1, 2));
  graph.arrows.push_back(arrowBetween(14, 3, 3));
  const std::vector<Problem> problems = problemsOf(graph);
  EXPECT_GE(problems.size(), 3u);
  const auto about = [&](const std::string& start) {
    for (const Problem& problem : problems) {
      if (problem.pointer.rfind(start, 0) == 0) return true;
    }
    return false;
  };
  EXPECT_TRUE(about("/graph/arrows/1"));
  EXPECT_TRUE(about("/graph/arrows/3"));
  EXPECT_TRUE(about("/graph/arrows/4"));
}

TEST(Validate, NamesSignalsOfMissingPointsAndUnorderedKeys) {
  WindGraph graph = smallTree();
  graph.signals.resize(2);
  graph.signals[0].root = 55;
  graph.signals[1].root = 1;
  graph.signals[1].kind = SignalKind::Curve;
  graph.signals[1].keys = {{2, 1}, {1, 1}};
  const std::vector<Problem> problems = problemsOf(graph);
  EXPECT_TRUE(hasProblem(problems, "/graph/signals/0/root"));
  EXPECT_GE(problems.size(), 2u);
}

TEST(Validate, PeriodicSidesNeedTheirPartner) {
  Project project;
  FieldSettings field;
  field.xMin = Border::Periodic;
  project.field = std::make_shared<FieldSettings>(field);
  EXPECT_FALSE(validate(project).empty());
  field.xMax = Border::Periodic;
  project.field = std::make_shared<FieldSettings>(field);
  EXPECT_TRUE(validate(project).empty());
}

TEST(Validate, RefusesNumbersThatAreNotFinite) {
  for (float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    WindGraph graph = smallTree();
    graph.points[0].position.x = bad;
    EXPECT_TRUE(hasProblem(problemsOf(graph), "/graph/points/0/position"));
  }
}

TEST(Parameters, DefaultsAreLegalAndExplained) {
  expectLegalDefaults<FieldSettings>();
  expectLegalDefaults<SolverSettings>();
  expectLegalDefaults<AmbientWind>();
  expectLegalDefaults<Point>();
  expectLegalDefaults<Arrow>();
  expectLegalDefaults<Signal>();
  expectLegalDefaults<Obstacle>();
  expectLegalDefaults<Species>();
  expectLegalDefaults<Collider>();
  expectLegalDefaults<Surface>();
  expectLegalDefaults<Rotor>();
  expectLegalDefaults<Probe>();
  expectLegalDefaults<Camera>();
  expectLegalDefaults<TerrainSettings>();
  expectLegalDefaults<GrassSettings>();
  expectLegalDefaults<BezierSettings>();
  expectLegalDefaults<ShellSettings>();
}

TEST(Parameters, ProblemsNameWhatWasFoundAndExpected) {
  for (const Parameter<Arrow>& parameter : parametersOf<Arrow>()) {
    if (parameter.info.key != "radius") continue;
    const std::string problem = parameterProblem(parameter.info, -3.0f);
    EXPECT_NE(problem.find("-3"), std::string::npos) << problem;
    EXPECT_NE(problem.find("expected"), std::string::npos) << problem;
    return;
  }
  FAIL() << "arrows have a radius";
}

TEST(Validate, AcceptsBranchesMergesRingsAndOppositeArrows) {
  EXPECT_EQ(pointersOf(withGraph([](WindGraph& g) {
              g.arrows.push_back(arrowBetween(13, 3, 1));
              g.arrows.push_back(arrowBetween(14, 2, 1));
              g.arrows.push_back(arrowBetween(15, 1, 3));
            })),
            Pointers{});
}

TEST(Validate, RefusesDanglingAndDegenerateArrows) {
  EXPECT_EQ(pointersOf(withGraph([](WindGraph& g) { g.arrows[0].from = g.arrows[1].to = 77; })),
            (Pointers{"/graph/arrows/0/from", "/graph/arrows/1/to"}));
  EXPECT_EQ(pointersOf(withGraph([](WindGraph& g) { g.arrows[1].to = 2; })), Pointers{"/graph/arrows/1/to"});
  EXPECT_EQ(pointersOf(withGraph([](WindGraph& g) { g.points[2].position = g.points[1].position; })),
            Pointers{"/graph/arrows/1"});
  EXPECT_EQ(pointersOf(withGraph([](WindGraph& g) { g.arrows.push_back(arrowBetween(20, 1, 2)); })),
            Pointers{"/graph/arrows/2"});
}

TEST(Validate, RefusesIdsThatAreZeroTooLargeOrUsedTwice) {
  EXPECT_EQ(pointersOf(withGraph([](WindGraph& g) { g.arrows[0].id = 0; })), Pointers{"/graph/arrows/0/id"});
  EXPECT_EQ(pointersOf(withGraph([](WindGraph& g) { g.arrows[0].id = 0xffffffffu; })), Pointers{"/graph/arrows/0/id"});
  EXPECT_EQ(pointersOf(withGraph([](WindGraph& g) { g.arrows[1].id = 11; })), Pointers{"/graph/arrows/1/id"});
  EXPECT_EQ(pointersOf(withGraph([](WindGraph& g) { g.arrows[1].id = 3; })), Pointers{"/graph/arrows/1/id"});
}

TEST(Validate, RefusesValuesOutOfRangeInEveryPart) {
  Project project = projectOf(line());
  project.name = "a\nb";
  project.field = changed(project.field, [](FieldSettings& f) { f.resolution = {0, 1000000000}; });
  project.solver = changed(project.solver, [](SolverSettings& s) { s.advection = static_cast<Advection>(7); });
  project.ambient = changed(project.ambient, [](AmbientWind& a) { a.gustStrength = -1; });
  project.graph =
      changed(project.graph, [](WindGraph& g) { g.points[1].position.y = std::numeric_limits<float>::infinity(); });
  project.terrain = changed(project.terrain, [](TerrainSettings& t) { t.colour.z = 2; });
  project.grass =
      changed(project.grass, [](GrassSettings& g) { g.shadowMin = std::numeric_limits<float>::quiet_NaN(); });
  EXPECT_EQ(pointersOf(project), (Pointers{"/name", "/field/resolution", "/solver/advection", "/ambient/gusts/strength",
                                           "/graph/points/1/position", "/terrain/colour", "/grass/shadow/min"}));
}

TEST(Validate, RefusesAPeriodicSideWithoutPartner) {
  Project project;
  project.field = changed(project.field, [](FieldSettings& f) { f.xMax = f.zMin = f.zMax = Border::Periodic; });
  EXPECT_EQ(pointersOf(project), Pointers{"/field/borders/xMin"});
}

TEST(Validate, RefusesSignalsThatHaveNoPlace) {
  Signal signal;
  signal.root = 1;
  EXPECT_EQ(pointersOf(withGraph([&](WindGraph& g) {
              g.signals = {signal, signal};
            })),
            Pointers{"/graph/signals/1/root"});
  signal.root = 99;
  EXPECT_EQ(pointersOf(withGraph([&](WindGraph& g) { g.signals = {signal}; })), Pointers{"/graph/signals/0/root"});
}

TEST(Validate, RefusesCurvesThatCanNotBePlayed) {
  Signal signal;
  signal.root = 1;
  signal.kind = SignalKind::Curve;
  const auto problemsWith = [&](std::vector<SignalKey> keys) {
    signal.keys = std::move(keys);
    return pointersOf(withGraph([&](WindGraph& g) { g.signals = {signal}; }));
  };
  EXPECT_EQ(problemsWith({{0, 1}, {3, 0}, {6, 1}}), Pointers{});
  EXPECT_EQ(problemsWith({{0, 1}, {2, 0}, {2, 1}}), Pointers{"/graph/signals/0/keys/2"});
  EXPECT_EQ(problemsWith({{0, 1}, {2, 9}}), Pointers{"/graph/signals/0/keys/1"});
  EXPECT_EQ(problemsWith({{0, 1}, {6.5f, 1}}), Pointers{"/graph/signals/0/keys/1"});
  EXPECT_EQ(problemsWith({{0, 1}, {6, 0}}), Pointers{"/graph/signals/0/keys"});
}

TEST(Validate, SpeciesAndCollidersNeedTheFilesOfTheirMeshes) {
  Project project;
  Species tuft;
  tuft.id = 1;
  tuft.shape = PlantShape::Mesh;
  Collider stone;
  stone.id = 2;
  stone.shape = ColliderShape::Mesh;
  const auto pointers = [&] {
    project.species = std::make_shared<std::vector<Species>>(1, tuft);
    project.colliders = std::make_shared<std::vector<Collider>>(1, stone);
    return pointersOf(project);
  };
  EXPECT_EQ(pointers(), (Pointers{"/species/0/file", "/colliders/0/file"}));
  tuft.file = stone.file = "assets/thing.glb";
  EXPECT_EQ(pointers(), Pointers{});
  tuft.file = "a//thing.glb";
  stone.file = "a\\thing.glb";
  EXPECT_EQ(pointers(), (Pointers{"/species/0/file", "/colliders/0/file"}));
  tuft.shape = PlantShape::Daisy;
  stone.shape = ColliderShape::Sphere;
  EXPECT_EQ(pointers(), (Pointers{"/species/0/file", "/colliders/0/file"})) << "kept for when the shape comes back";
}

TEST(Validate, RefusesMapsThatAreNoPaths) {
  Project project;
  project.grass = changed(project.grass, [](GrassSettings& g) {
    g.densityMap = "./mask.png";
    g.heightMap = "assets/height.png";
    g.colourMap = "a\\b.png";
  });
  EXPECT_EQ(pointersOf(project), (Pointers{"/grass/maps/density", "/grass/maps/colour"}));
}

TEST(Validate, RefusesCollidersThatCanNotMove) {
  Project project;
  Collider ball;
  ball.id = 1;
  const auto problemsWith = [&](std::vector<ColliderKey> keys) {
    ball.keys = std::move(keys);
    project.colliders = std::make_shared<std::vector<Collider>>(1, ball);
    return pointersOf(project);
  };
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinite = std::numeric_limits<float>::infinity();
  EXPECT_EQ(problemsWith({{0, {0, 0, 0}}, {1.5f, {-4, 0.5f, 3}}}), Pointers{});
  EXPECT_EQ(problemsWith({{2, {}}}), Pointers{}) << "one key alone is a place";
  EXPECT_EQ(problemsWith({{1, {}}, {1, {}}}), Pointers{"/colliders/0/keys/1"});
  EXPECT_EQ(problemsWith({{1, {}}, {0.5f, {}}}), Pointers{"/colliders/0/keys/1"});
  EXPECT_EQ(problemsWith({{-1, {}}}), Pointers{"/colliders/0/keys/0"});
  EXPECT_EQ(problemsWith({{kNan, {}}}), Pointers{"/colliders/0/keys/0"});
  EXPECT_EQ(problemsWith({{kInfinite, {}}}), Pointers{"/colliders/0/keys/0"});
  EXPECT_EQ(problemsWith({{4000, {}}}), Pointers{"/colliders/0/keys/0"});
  EXPECT_EQ(problemsWith({{0, {kNan, 0, 0}}}), Pointers{"/colliders/0/keys/0"});
  EXPECT_EQ(problemsWith({{0, {0, kInfinite, 0}}}), Pointers{"/colliders/0/keys/0"});
  EXPECT_EQ(problemsWith({{0, {0, 0, 2e5f}}}), Pointers{"/colliders/0/keys/0"});
  std::vector<ColliderKey> many(kMaxColliderKeys + 1);
  for (std::size_t i = 0; i < many.size(); ++i) many[i].time = 0.01f * static_cast<float>(i);
  EXPECT_EQ(problemsWith(many), Pointers{"/colliders/0/keys"});
}

TEST(Validate, RefusesValuesOutOfRangeInSpeciesAndColliders) {
  Project project;
  Species daisy;
  daisy.id = 1;
  daisy.weight = -1;
  daisy.tipColour.y = 1.5f;
  Collider ball;
  ball.id = 2;
  ball.radius = 0;
  ball.position.x = std::numeric_limits<float>::quiet_NaN();
  project.species = std::make_shared<std::vector<Species>>(1, daisy);
  project.colliders = std::make_shared<std::vector<Collider>>(1, ball);
  project.grass = changed(project.grass, [](GrassSettings& g) {
    g.swingDamping = 0;
    g.interacting = 200'000;
  });
  EXPECT_EQ(pointersOf(project), (Pointers{"/grass/swing/damping", "/grass/interacting", "/species/0/weight",
                                           "/species/0/colours/tip", "/colliders/0/position", "/colliders/0/radius"}));
}

TEST(Validate, IdsAreUniqueOverSpeciesAndCollidersToo) {
  Project project = projectOf(line());
  Species daisy;
  daisy.id = 1;  // a point's
  Collider ball;
  ball.id = 60;
  project.species = std::make_shared<std::vector<Species>>(1, daisy);
  project.colliders = std::make_shared<std::vector<Collider>>(2, ball);
  EXPECT_EQ(pointersOf(project), (Pointers{"/species/0/id", "/colliders/1/id"}));
}

TEST(Validate, SurfacesNeedTheFilesOfTheirMeshes) {
  Project project;
  Surface rock;
  rock.id = 1;
  const auto pointers = [&](SurfaceShape shape, const char* file) {
    rock.shape = shape;
    rock.file = file;
    project.surfaces = std::make_shared<std::vector<Surface>>(1, rock);
    return pointersOf(project);
  };
  EXPECT_EQ(pointers(SurfaceShape::Hare, ""), Pointers{});
  EXPECT_EQ(pointers(SurfaceShape::Mesh, ""), Pointers{"/surfaces/0/file"});
  EXPECT_EQ(pointers(SurfaceShape::Mesh, "assets/rock.glb"), Pointers{});
  EXPECT_EQ(pointers(SurfaceShape::Mesh, "a//rock.glb"), Pointers{"/surfaces/0/file"});
  EXPECT_EQ(pointers(SurfaceShape::Hare, "./rock.glb"), Pointers{"/surfaces/0/file"}) << "kept for the mesh";
}

TEST(Validate, RefusesValuesOutOfRangeInSurfacesAndRotors) {
  Project project;
  Surface ball;
  ball.id = 1;
  ball.size = 0;
  ball.density = std::numeric_limits<float>::quiet_NaN();
  Rotor rotor;
  rotor.id = 2;
  rotor.lift = -1;
  rotor.rings = 1.5f;
  project.surfaces = std::make_shared<std::vector<Surface>>(1, ball);
  project.rotors = std::make_shared<std::vector<Rotor>>(1, rotor);
  EXPECT_EQ(pointersOf(project),
            (Pointers{"/surfaces/0/size", "/surfaces/0/density", "/rotors/0/lift", "/rotors/0/rings"}));
}

TEST(Validate, AChangeBringsNoNewFilesOutsideTheProjectsFolder) {
  Project old;
  Species tuft;
  tuft.id = 1;
  tuft.shape = PlantShape::Mesh;
  tuft.file = "../library/tuft.glb";
  old.species = std::make_shared<std::vector<Species>>(1, tuft);
  EXPECT_EQ(pointersOf(old), Pointers{}) << "a file may name them, which doesn't yet read them";
  const auto pointers = [&](const Project& project) {
    Pointers found;
    for (const Problem& problem : validateChange(project, old)) found.push_back(problem.pointer);
    return found;
  };
  Project changed = old;
  tuft.name = "Tuft";
  changed.species = std::make_shared<std::vector<Species>>(1, tuft);
  EXPECT_EQ(pointers(changed), Pointers{}) << "what is there may stay";
  tuft.file = "/etc/tuft.glb";
  changed.species = std::make_shared<std::vector<Species>>(1, tuft);
  EXPECT_EQ(pointers(changed), Pointers{"/species/0/file"});
}

TEST(Validate, RefusesShellsOutOfRangeAndPicturesThatAreNoPaths) {
  const auto pointers = [](auto&& change) {
    Project project;
    project.shell = changed(project.shell, change);
    return pointersOf(project);
  };
  EXPECT_EQ(pointers([](ShellSettings& s) { s.texture = "assets/blades.png"; }), Pointers{});
  EXPECT_EQ(pointers([](ShellSettings& s) { s.texture = "a//blades.png"; }), Pointers{"/shell/texture/file"});
  EXPECT_EQ(
      pointers([](ShellSettings& s) {
        s.shells = 0;
        s.texels = 2048;
        s.heightCurve = 0.5f;
        s.stiffnessCurve = std::numeric_limits<float>::quiet_NaN();
        s.overBend = 2.1f;
        s.source.y = std::numeric_limits<float>::infinity();
        s.sourceStep = 0;
      }),
      (Pointers{"/shell/shells", "/shell/texture/texels", "/shell/texture/heightCurve", "/shell/bend/stiffnessCurve",
                "/shell/bend/overBend", "/shell/wind/sourcePosition", "/shell/wind/sourceStep"}));
}

TEST(Validate, GravityOfBezierGrassNeedsADirectionOfAnyLength) {
  const auto pointers = [](glm::vec3 direction) {
    Project project;
    project.bezier = changed(project.bezier, [&](BezierSettings& b) { b.gravityDirection = direction; });
    return pointersOf(project);
  };
  EXPECT_EQ(pointers({0, 0, 0}), Pointers{"/bezier/gravity/direction"});
  EXPECT_EQ(pointers({0, 0, 0.001f}), Pointers{});
  EXPECT_EQ(pointers({0, 50, 0}), Pointers{});
  EXPECT_EQ(pointers({0, std::numeric_limits<float>::quiet_NaN(), 0}), Pointers{"/bezier/gravity/direction"});
}

TEST(Validate, IdsAreUniqueOverSurfacesAndRotorsToo) {
  Project project = projectOf(line());
  Surface ball;
  ball.id = 1;  // a point's
  Rotor rotor;
  rotor.id = 60;
  project.surfaces = std::make_shared<std::vector<Surface>>(1, ball);
  project.rotors = std::make_shared<std::vector<Rotor>>(2, rotor);
  EXPECT_EQ(pointersOf(project), (Pointers{"/surfaces/0/id", "/rotors/1/id"}));
}

TEST(Validate, RefusesACameraThatLooksAtItself) {
  Project project;
  Camera camera;
  camera.id = 1;
  camera.target = camera.position;
  project.cameras = std::make_shared<std::vector<Camera>>(1, camera);
  EXPECT_EQ(pointersOf(project), Pointers{"/cameras/0/target"});
}

TEST(Validate, RefusesMoreBladesThanThereMayBe) {
  Project project;
  project.field = changed(project.field, [](FieldSettings& f) { f.size = {5000, 5000}; });
  EXPECT_EQ(pointersOf(project), Pointers{"/grass/density"});
}

TEST(Validate, RefusesMoreRecordsThanThereMayBe) {
  Project project;
  project.probes = std::make_shared<std::vector<Probe>>(kMaxProbes + 1);
  EXPECT_EQ(pointersOf(project).front(), "/probes");
  project.species = std::make_shared<std::vector<Species>>(kMaxSpecies + 1);
  EXPECT_EQ(pointersOf(project).front(), "/species");
  project.species = std::make_shared<std::vector<Species>>();
  project.colliders = std::make_shared<std::vector<Collider>>(kMaxColliders + 1);
  EXPECT_EQ(pointersOf(project).front(), "/colliders");
  project.colliders = std::make_shared<std::vector<Collider>>();
  project.surfaces = std::make_shared<std::vector<Surface>>(kMaxSurfaces + 1);
  EXPECT_EQ(pointersOf(project).front(), "/surfaces");
  project.surfaces = std::make_shared<std::vector<Surface>>();
  project.rotors = std::make_shared<std::vector<Rotor>>(kMaxRotors + 1);
  EXPECT_EQ(pointersOf(project).front(), "/rotors");
}

TEST(ValidateChange, ReadsWhatChangedAndWhatBindsItToTheRest) {
  const Project valid = projectOf(line());
  Project project = valid;
  Obstacle rock;
  rock.id = 12;
  project.obstacles = std::make_shared<std::vector<Obstacle>>(1, rock);
  const std::vector<Problem> problems = validateChange(project, valid);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].pointer, "/obstacles/0/id");
  EXPECT_TRUE(validateChange(valid, valid).empty());
}

}  // namespace windloom
