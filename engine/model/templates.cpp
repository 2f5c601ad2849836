#include "engine/model/templates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string>

#include "engine/model/calibration_card.hpp"

namespace windloom {
namespace {

/// Gathers the parts of a project. Each kind of record counts its ids from a round number of its own,
/// so that a file can be read and edited by hand.
class Composer {
 public:
  explicit Composer(std::string name) { m_project.name = std::move(name); }

  FieldSettings field;
  AmbientWind ambient;
  SolverSettings solver;
  GrassSettings grass;
  Arrow style;  ///< how the arrows added next blow

  Id point(glm::vec2 position, std::string name = {}) {
    Point& added = m_graph.points.emplace_back();
    added.id = ++m_lastPoint;
    added.name = std::move(name);
    added.position = position;
    return added.id;
  }

  Arrow& arrow(Id from, Id to, float strength) {
    Arrow& added = m_graph.arrows.emplace_back(style);
    added.id = ++m_lastArrow;
    added.from = from;
    added.to = to;
    added.strength = strength;
    return added;
  }

  /// Arrows from `from` through new points; the last point. Each arrow is weaker than the one before it.
  Id chain(Id from, std::initializer_list<glm::vec2> way, float strength, float falloff = 0.9f) {
    for (const glm::vec2 position : way) {
      const Id next = point(position);
      arrow(from, next, strength);
      from = next;
      strength = std::round(strength * falloff * 10) / 10;
    }
    return from;
  }

  Signal& signal(Id root, SignalKind kind) {
    Signal& added = m_graph.signals.emplace_back();
    added.root = root;
    added.kind = kind;
    return added;
  }

  void circle(glm::vec2 centre, float radius, float height) {
    Obstacle& added = obstacle(centre, height);
    added.shape = ObstacleShape::Circle;
    added.radius = radius;
  }

  void box(glm::vec2 centre, glm::vec2 size, float rotation, float height) {
    Obstacle& added = obstacle(centre, height);
    added.shape = ObstacleShape::Box;
    added.size = size;
    added.rotation = rotation;
  }

  Species& species(PlantShape shape, std::string name) {
    Species& added = m_species.emplace_back();
    added.id = 600 + static_cast<Id>(m_species.size());
    added.name = std::move(name);
    added.shape = shape;
    return added;
  }

  void probe(glm::vec2 position, std::string name) {
    Probe& added = m_probes.emplace_back();
    added.id = 400 + static_cast<Id>(m_probes.size());
    added.name = std::move(name);
    added.position = position;
  }

  void camera(std::string name, glm::vec3 position, glm::vec3 target, float fieldOfView = 45) {
    Camera& added = m_cameras.emplace_back();
    added.id = 500 + static_cast<Id>(m_cameras.size());
    added.name = std::move(name);
    added.position = position;
    added.target = target;
    added.fieldOfView = fieldOfView;
  }

  /// Adds the camera that sees the whole field from above, and puts all together.
  Project finish() {
    constexpr float kFieldOfView = 45;
    const float reach = 0.54f * std::max(field.size.y, field.size.x * 9 / 16);
    const float height = std::round(reach / std::tan(kFieldOfView * std::numbers::pi_v<float> / 360));
    camera("top", {field.centre.x, height, field.centre.y + 1}, {field.centre.x, 0, field.centre.y}, kFieldOfView);
    m_project.field = std::make_shared<FieldSettings>(field);
    m_project.ambient = std::make_shared<AmbientWind>(ambient);
    m_project.solver = std::make_shared<SolverSettings>(solver);
    m_project.grass = std::make_shared<GrassSettings>(grass);
    m_project.graph = std::make_shared<WindGraph>(std::move(m_graph));
    m_project.obstacles = std::make_shared<std::vector<Obstacle>>(std::move(m_obstacles));
    m_project.species = std::make_shared<std::vector<Species>>(std::move(m_species));
    m_project.probes = std::make_shared<std::vector<Probe>>(std::move(m_probes));
    m_project.cameras = std::make_shared<std::vector<Camera>>(std::move(m_cameras));
    return std::move(m_project);
  }

 private:
  Obstacle& obstacle(glm::vec2 centre, float height) {
    Obstacle& added = m_obstacles.emplace_back();
    added.id = 300 + static_cast<Id>(m_obstacles.size());
    added.centre = centre;
    added.height = height;
    return added;
  }

  Project m_project;
  WindGraph m_graph;
  std::vector<Obstacle> m_obstacles;
  std::vector<Species> m_species;
  std::vector<Probe> m_probes;
  std::vector<Camera> m_cameras;
  Id m_lastPoint = 0;
  Id m_lastArrow = 100;
};

AmbientWind ambientWind(float speed, float direction, float gustStrength, float gustSize, float gustSpeed) {
  AmbientWind wind;
  wind.speed = speed;
  wind.direction = direction;
  wind.gustStrength = gustStrength;
  wind.gustSize = gustSize;
  wind.gustSpeed = gustSpeed;
  return wind;
}

/// Some among the meadow's own blades, in patches.
void growFlowers(Composer& make) {
  Species& seedHeads = make.species(PlantShape::Blade, "seed heads");
  seedHeads.weight = 0.1f;
  seedHeads.patchiness = 0.75f;
  seedHeads.patchSize = 14;
  seedHeads.height = 0.82f;
  seedHeads.heightVariation = 0.25f;
  seedHeads.width = 0.014f;
  seedHeads.stiffness = 0.8f;
  seedHeads.baseColour = {0.05f, 0.085f, 0.02f};
  seedHeads.tipColour = {0.46f, 0.4f, 0.17f};
  Species& daisies = make.species(PlantShape::Daisy, "daisies");
  daisies.weight = 0.03f;
  daisies.patchiness = 0.85f;
  daisies.patchSize = 6;
  daisies.height = 0.58f;
  daisies.heightVariation = 0.25f;
  daisies.width = 0.006f;
  daisies.stiffness = 1.2f;
  daisies.baseColour = {0.04f, 0.085f, 0.016f};
  daisies.tipColour = {0.86f, 0.86f, 0.82f};
  Species& poppies = make.species(PlantShape::Poppy, "poppies");
  poppies.weight = 0.012f;
  poppies.patchiness = 0.9f;
  poppies.patchSize = 10;
  poppies.height = 0.66f;
  poppies.heightVariation = 0.2f;
  poppies.width = 0.006f;
  poppies.baseColour = {0.045f, 0.085f, 0.02f};
  poppies.tipColour = {0.5f, 0.02f, 0.01f};
}

Project makeMeadow() {
  Composer make("Meadow");
  make.ambient = ambientWind(1.8f, -18, 0.35f, 14, 3);
  make.style.radius = 5;
  const Id gate = make.point({-37, 30}, "gate");
  const Id bend = make.point({-24, 21}, "bend");
  const Id fork = make.point({-11, 11}, "fork");
  make.arrow(gate, bend, 11);
  make.arrow(bend, fork, 10);
  make.style.radius = 4.5f;
  const Id hollow = make.chain(fork, {{-5, -3}, {-3, -17}}, 9);
  make.style.radius = 4;
  make.chain(hollow, {{-12, -28}, {-24, -35}}, 7);
  make.chain(hollow, {{7, -27}, {14, -39}}, 7);
  make.style.radius = 4.5f;
  const Id rise = make.chain(fork, {{4, 7}, {18, 0}}, 9);
  make.style.radius = 4;
  make.chain(rise, {{28, -10}, {39, -24}}, 7);
  make.chain(rise, {{31, 6}, {42, 14}}, 7);
  make.chain(fork, {{0, 20}, {12, 26}}, 6);
  Signal& pulse = make.signal(gate, SignalKind::Pulse);
  pulse.period = 7;
  pulse.on = 3.2f;
  pulse.attack = 0.5f;
  pulse.release = 1.6f;
  growFlowers(make);
  make.probe({-11, 11}, "fork");
  make.probe({-24, -35}, "far left");
  make.probe({39, -24}, "far right");
  make.camera("hero", {-40, 2.6f, 40}, {-2, 0, 4}, 48);
  make.camera("hill", {-34, 15, 58}, {2, 0, -4}, 42);
  return make.finish();
}

Project makeEmpty() {
  Composer make("Empty");
  make.camera("hero", {0, 2.4f, 40}, {0, 0.6f, 0}, 48);
  return make.finish();
}

Project makeBreeze() {
  Composer make("Breeze");
  make.ambient = ambientWind(3, 8, 0.4f, 18, 4);
  make.style.radius = 9;
  make.style.response = 0.6f;
  const Id west = make.point({-42, -6}, "west");
  const Id middle = make.chain(west, {{-20, -2}, {2, 4}}, 5);
  make.chain(middle, {{22, -4}, {42, -14}}, 4);
  make.chain(middle, {{22, 13}, {42, 18}}, 4);
  Signal& gusts = make.signal(west, SignalKind::Gusts);
  gusts.attack = 1.5f;
  gusts.depth = 0.7f;
  gusts.rate = 0.35f;
  make.probe({2, 4}, "middle");
  make.camera("hero", {-40, 2.4f, 16}, {4, 0, 0}, 48);
  return make.finish();
}

Project makeGustFront() {
  Composer make("Gust front");
  make.ambient = ambientWind(1, 0, 0.2f, 16, 2);
  make.style.radius = 7;
  make.style.travelSpeed = 9;
  for (int lane = -2; lane <= 2; ++lane) {
    const float z = 15.0f * static_cast<float>(lane);
    const float bow = 2.0f * static_cast<float>(lane * lane);  // the middle of a front runs ahead
    const Id start = make.point({-44 + bow / 4, z}, "lane " + std::to_string(lane + 3));
    make.chain(start, {{-18, z}, {8, z * 1.05f}, {32 - bow, z * 1.12f}}, 14, 0.95f);
    Signal& pulse = make.signal(start, SignalKind::Pulse);
    pulse.period = 14;
    pulse.on = 3.5f;
    pulse.attack = 0.8f;
    pulse.release = 3;
    pulse.delay = 0.15f * bow / 2;
  }
  make.probe({0, 0}, "middle");
  make.camera("hero", {24, 2.8f, 36}, {-14, 0.4f, -6}, 48);
  return make.finish();
}

Project makeCanyonFunnel() {
  Composer make("Canyon");
  make.field.size = {120, 60};
  make.field.resolution = {1200, 600};
  make.field.zMin = make.field.zMax = Border::Wall;
  make.ambient = ambientWind(5, 0, 0.2f, 15, 5);
  make.box({-16, -25}, {52, 10}, 12, 7);
  make.box({-16, 25}, {52, 10}, -12, 7);
  make.box({32, -25}, {40, 8}, -8, 6);
  make.box({32, 25}, {40, 8}, 8, 6);
  make.circle({14, 0}, 3, 4);
  make.circle({30, -7}, 2.2f, 3);
  make.circle({32, 8}, 2.6f, 3.5f);
  make.circle({46, 1}, 1.8f, 2.5f);
  make.style.radius = 6;
  make.style.response = 0.5f;
  const Id mouth = make.point({-52, 0}, "mouth");
  make.chain(mouth, {{-30, 0}, {-6, 0}}, 8, 1);
  make.signal(mouth, SignalKind::Gusts).attack = 2;
  make.probe({4, 0}, "throat");
  make.probe({22, 0}, "lee");
  make.camera("hero", {-30, 3, 7}, {18, 0.5f, 0}, 50);
  make.camera("ridge", {-44, 26, 40}, {12, 0, 0}, 42);
  return make.finish();
}

Project makeWhirlwind() {
  Composer make("Whirlwind");
  make.field.size = {60, 60};
  make.field.resolution = {600, 600};
  make.ambient = ambientWind(0.8f, 20, 0.2f, 10, 2);
  constexpr int kPosts = 8;
  constexpr float kRingRadius = 9;
  make.style.radius = 3;
  make.style.travelSpeed = 14;
  const Id feed = make.point({-26, -kRingRadius}, "feed");
  std::array<Id, kPosts> ring{};
  for (int i = 0; i < kPosts; ++i) {
    const float angle = (static_cast<float>(i) / kPosts - 0.25f) * 2 * std::numbers::pi_v<float>;
    const glm::vec2 position{kRingRadius * std::cos(angle), kRingRadius * std::sin(angle)};
    ring[static_cast<std::size_t>(i)] = make.point(glm::round(position * 100.0f) / 100.0f);
  }
  make.arrow(feed, ring[0], 7);
  for (std::size_t i = 0; i < kPosts; ++i) make.arrow(ring[i], ring[(i + 1) % kPosts], 10);
  const Id edge = make.point({0, 4}, "eye edge");
  const Id eye = make.point({0, 0}, "eye");
  Arrow& core = make.arrow(edge, eye, 0.5f);
  core.where = Where::End;
  core.radius = 6;
  core.swirl = 12;
  make.probe({0, 0}, "eye");
  make.probe({kRingRadius, 0}, "ring");
  make.camera("hero", {-20, 2.8f, 24}, {2, 0.4f, -2}, 48);
  return make.finish();
}

Project makeHelicopterDownwash() {
  Composer make("Helicopter downwash");
  make.field.size = {60, 60};
  make.field.resolution = {600, 600};
  constexpr int kSpokes = 10;
  make.style.radius = 2.6f;
  make.style.response = 0.15f;
  make.style.travelSpeed = 25;
  const Id hub = make.point({0, 0}, "rotor");
  for (int i = 0; i < kSpokes; ++i) {
    const float angle = static_cast<float>(i) / kSpokes * 2 * std::numbers::pi_v<float>;
    const glm::vec2 out = glm::vec2(std::cos(angle), std::sin(angle));
    const Id near = make.point(glm::round(out * 900.0f) / 100.0f);
    const Id far = make.point(glm::round(out * 2000.0f) / 100.0f);
    make.arrow(hub, near, 15);
    make.arrow(near, far, 9).swirl = i % 2 == 0 ? 4.0f : -4.0f;
  }
  Signal& rotor = make.signal(hub, SignalKind::Gusts);
  rotor.attack = 2;
  rotor.depth = 0.45f;
  rotor.rate = 4;
  make.probe({9, 0}, "near");
  make.probe({20, 0}, "far");
  make.camera("hero", {-14, 3, 25}, {1, 0, -2}, 50);
  return make.finish();
}

Project makeCollidingWinds() {
  Composer make("Colliding winds");
  make.style.radius = 5;
  const Id west = make.point({-40, 0}, "west");
  make.chain(west, {{-22, 0}, {-6, 0}}, 10, 1);
  const Id east = make.point({40, 0}, "east");
  make.chain(east, {{22, 0}, {6, 0}}, 10, 1);
  make.signal(west, SignalKind::Constant).attack = 1;
  make.signal(east, SignalKind::Constant).attack = 1;
  make.probe({0, 0}, "meeting");
  make.probe({0, 16}, "thrown aside");
  make.camera("hero", {-2, 3, 33}, {0, 0, -4}, 54);
  return make.finish();
}

Project makeDoorwayDraught() {
  Composer make("Doorway draught");
  make.field.size = {40, 30};
  make.field.resolution = {800, 600};
  make.field.zMin = make.field.zMax = Border::Wall;
  make.grass.density = 400;
  make.box({0, -8.5f}, {0.8f, 13}, 0, 3);
  make.box({0, 8.5f}, {0.8f, 13}, 0, 3);
  make.style.radius = 1.6f;
  make.style.travelSpeed = 6;
  const Id outside = make.point({-14, 0}, "outside");
  const Id door = make.point({-1, 0}, "door");
  make.arrow(outside, door, 4);
  const Id inside = make.chain(door, {{5, 0}}, 6);
  make.chain(inside, {{11, -3}}, 4);
  make.chain(inside, {{11, 3.5f}}, 4);
  Signal& pulse = make.signal(outside, SignalKind::Pulse);
  pulse.period = 8;
  pulse.on = 4;
  pulse.attack = 0.6f;
  pulse.release = 2;
  make.probe({0, 0}, "doorway");
  make.camera("hero", {15, 2.2f, 9}, {-2, 0.4f, -1}, 50);
  return make.finish();
}

Project makeCalibration() {
  Composer make("Calibration card");
  make.solver.source = WindSource::Card;
  // Neither square nor around the origin: a swapped axis or a lost offset shows.
  make.field.centre = {8, -4};
  make.field.size = {64, 48};
  make.field.resolution = {128, 96};
  make.field.xMin = make.field.xMax = make.field.zMin = make.field.zMax = Border::Periodic;
  // The axes, as arrows to find again in the game: red would be x, blue z.
  const Id middle = make.point({8, -4}, "middle");
  make.arrow(middle, make.point({24, -4}, "plus x"), kCardSpeed);
  make.arrow(middle, make.point({8, 8}, "plus z"), kCardSpeed);
  make.probe({8, -4}, "middle");
  make.camera("hero", {8, 9, 34}, {8, 0, -4}, 55);
  return make.finish();
}

}  // namespace

std::span<const ProjectTemplate> projectTemplates() {
  static constexpr std::array kTemplates{
      ProjectTemplate{"meadow", "Meadow", "A branching tree of wind sweeps over open grass in pulses.", makeMeadow},
      ProjectTemplate{"empty", "Empty", "Still air over flat grass.", makeEmpty},
      ProjectTemplate{"breeze", "Breeze", "A wide, soft wind that swells and eases.", makeBreeze},
      ProjectTemplate{"gust-front", "Gust front", "Five lanes of wind arrive as one rolling front.", makeGustFront},
      ProjectTemplate{"canyon-funnel", "Canyon funnel", "A stream narrows between cliffs and breaks around rocks.",
                      makeCanyonFunnel},
      ProjectTemplate{"whirlwind", "Whirlwind", "A ring of arrows, fed from outside, turns around a still eye.",
                      makeWhirlwind},
      ProjectTemplate{"helicopter-downwash", "Helicopter downwash", "Air hits the ground and flees to all sides.",
                      makeHelicopterDownwash},
      ProjectTemplate{"colliding-winds", "Colliding winds", "Two opposite winds meet and turn each other aside.",
                      makeCollidingWinds},
      ProjectTemplate{"doorway-draught", "Doorway draught", "Air bursts through a gap in a wall and spreads behind it.",
                      makeDoorwayDraught},
      ProjectTemplate{"calibration", "Calibration card", "A known wind for checking how an export arrives in a game.",
                      makeCalibration}};
  return kTemplates;
}

const ProjectTemplate* findTemplate(std::string_view name) {
  const auto all = projectTemplates();
  const auto found = std::ranges::find(all, name, &ProjectTemplate::name);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace windloom
