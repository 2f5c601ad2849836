#pragma once
// The project: everything an artist made, as one value. Metres, seconds, degrees; the world is
// right-handed with +Y up and the wind field lies in the XZ plane, so a 2D position is (x, z).
//
// A Project is cheap to copy: its parts are shared and immutable. Equal pointers mean unchanged, for
// history, session and dirty flag alike. It changes only through applyEdit (edit.hpp).

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "engine/model/height_field.hpp"
#include "engine/model/plant_mesh.hpp"
#include "engine/model/wind_graph.hpp"

namespace windloom {

inline constexpr int kProjectVersion = 1;

enum class Border {
  Open,      ///< air enters and leaves freely (p = 0)
  Wall,      ///< no flow through it, slip along it
  Periodic,  ///< joined to the opposite side; both sides must be periodic
};

struct FieldSettings {
  glm::vec2 centre{0.0f, 0.0f};       ///< m
  glm::vec2 size{100.0f, 100.0f};     ///< m
  glm::ivec2 resolution{1000, 1000};  ///< cells
  Border xMin = Border::Open, xMax = Border::Open, zMin = Border::Open, zMax = Border::Open;
  float timeStep = 1.0f / 60.0f;  ///< s
  std::string extra;              ///< unknown keys as read: the text of a JSON object, or empty
};

enum class Backend { Auto, Gpu, Cpu };
enum class Advection { MacCormack, SemiLagrangian };
enum class Pressure { Multigrid, Jacobi };
enum class WindSource {
  Solved,  ///< the arrows and the ambient wind drive the air
  Card,    ///< the calibration card (model/calibration_card.hpp); arrows and ambient wind have no effect
};

struct SolverSettings {
  WindSource source = WindSource::Solved;
  Backend backend = Backend::Auto;  ///< Auto: the GPU, but the CPU where OpenGL is a software renderer
  Advection advection = Advection::MacCormack;
  Pressure pressure = Pressure::Multigrid;
  float divergenceTolerance = 1e-3f;  ///< multigrid stops when RMS(div) after / before is below this
  int maxCycles = 8;                  ///< multigrid: at most so many V-cycles a step
  int jacobiSweeps = 20;              ///< Jacobi: sweeps a step (the paper's scheme)
  float confinement = 0.2f;           ///< vorticity confinement, dimensionless, bounded by local speed
  float viscosity = 0.0f;             ///< kinematic, m^2/s
  float dissipation = 0.1f;           ///< k, 1/s: the field relaxes to the ambient wind as 1/(1 + k dt)
  float maxSpeed = 100.0f;            ///< m/s: no cell is ever faster
  int seed = 7;
  std::string extra;
};

/// Wind that blows everywhere, from outside the field.
struct AmbientWind {
  float speed = 0.0f;         ///< m/s
  float direction = 0.0f;     ///< deg from +X towards +Z: where the air goes to
  float gustStrength = 0.0f;  ///< amplitude of the travelling gusts as a part of `speed`
  float gustSize = 12.0f;     ///< m: wavelength of the gust pattern
  float gustSpeed = 3.0f;     ///< m/s: how fast the pattern travels along `direction`
  std::string extra;
};

enum class ObstacleShape { Circle, Box, Polygon };

/// A solid: no air flows through it.
struct Obstacle {
  Id id = 0;
  std::string name;
  ObstacleShape shape = ObstacleShape::Circle;
  glm::vec2 centre{0.0f, 0.0f};   ///< m
  float radius = 3.0f;            ///< m; circle only
  glm::vec2 size{4.0f, 4.0f};     ///< m, along its own axes; box only
  float rotation = 0.0f;          ///< deg from +X towards +Z; box and polygon
  std::vector<glm::vec2> points;  ///< m, corners from the centre along its own axes; polygon only
  float height = 2.0f;            ///< m; how high it is drawn
  bool hidden = false, muted = false, locked = false;
  std::string extra;

  bool operator==(const Obstacle&) const = default;
};

/// A place where the wind is watched.
struct Probe {
  Id id = 0;
  std::string name;
  glm::vec2 position{0.0f, 0.0f};  ///< m
  bool hidden = false, locked = false;
  std::string extra;

  bool operator==(const Probe&) const = default;
};

struct Camera {
  Id id = 0;
  std::string name;
  glm::vec3 position{0.0f, 20.0f, 60.0f};  ///< m
  glm::vec3 target{0.0f, 0.0f, 0.0f};      ///< m
  float fieldOfView = 45.0f;               ///< deg, vertical
  std::string extra;

  bool operator==(const Camera&) const = default;
};

struct TerrainSettings {
  TerrainKind kind = TerrainKind::Flat;
  std::string file;                       ///< below the project's folder, '/' between folders; not for flat ground
  glm::vec2 centre{0.0f, 0.0f};           ///< m; of the height map, or of the mesh's own origin
  glm::vec2 size{100.0f, 100.0f};         ///< m; height map only
  float height = 10.0f;                   ///< m: white over black; height map only
  float base = 0.0f;                      ///< m: height of black, or of the mesh's own zero
  float scale = 1.0f;                     ///< of the mesh
  glm::vec3 colour{0.17f, 0.15f, 0.08f};  ///< bare ground between the blades, linear RGB
  std::string extra;

  /// The ground's shape; null: flat at 0. Never saved: engine/io reads it from `file`. Edits keep it in step with
  /// the values above (placedHeights).
  std::shared_ptr<const HeightField> heights;
};

enum class GrassKind {
  Instanced,
  Bezier,  ///< blades with a memory each, on ground and surfaces (BezierSettings)
  Shell,   ///< layers with cuts through blades, on ground and surfaces (ShellSettings)
  None,    ///< bare ground, to see the wind alone
};
enum class Deformation {
  Arc,        ///< keeps the blade's length, never lies down (reference/cwd-sim section 3, `arc`)
  Quadratic,  ///< CWD-Sim eq. 11-13 as printed, with the axis fix
  Inertial,   ///< chains of segments that overshoot and settle (reference/inertial-grass)
};

struct GrassSettings {
  GrassKind kind = GrassKind::Instanced;
  float density = 100.0f;  ///< blades per m^2
  int seed = 1;
  float height = 0.55f;             ///< m
  float heightVariation = 0.35f;    ///< part of the height, 0..1
  float width = 0.022f;             ///< m, at the base
  float stiffness = 1.0f;           ///< 1 = meadow grass; doubling it halves the bend for the same wind
  float stiffnessVariation = 0.3f;  ///< part of the stiffness, 0..1
  float clumping = 0.5f;            ///< how strongly neighbours share height, lean and colour, 0..1
  Deformation deformation = Deformation::Arc;
  float windFactor = 0.06f;                      ///< F of CWD-Sim eq. 12: bend per m/s
  float droopDown = 0.05f;                       ///< k1 of eq. 11
  float droopForward = 0.1f;                     ///< k2 of eq. 11
  float restBlend = 0.2f;                        ///< lambda of eq. 13
  float flutter = 0.35f;                         ///< strength of the small motion around the bent pose, 0..1
  glm::vec3 baseColour{0.035f, 0.075f, 0.014f};  ///< linear RGB at the root
  glm::vec3 tipColour{0.30f, 0.42f, 0.085f};     ///< linear RGB at the tip
  glm::vec3 dryColour{0.46f, 0.38f, 0.15f};      ///< what some clumps lean to
  float dryness = 0.25f;                         ///< part of the clumps that lean to dryColour, 0..1
  float shadowMin = 0.35f;                       ///< m_min of eq. 14
  float shadowMax = 1.0f;                        ///< m_max of eq. 14
  float shadowWind = 0.25f;                      ///< c1 of eq. 14
  float shadowOffset = 0.45f;                    ///< c2 of eq. 14
  float swingRate = 1.4f;            ///< Hz: how fast a pushed blade swings; inertial, and blades that objects bent
  float swingDamping = 0.18f;        ///< of critical damping, 0.02..1
  float windExponent = 4.0f / 3.0f;  ///< beta: how the force grows with the wind, 1..2; inertial
  float slopeAlign = 0.3f;           ///< 0 upright, 1 at right angles to the ground
  float slopeLimit = 50.0f;          ///< deg: no grass on ground steeper than this
  int interacting = 20'000;          ///< blades at most that remember what touched them
  std::string densityMap;  ///< picture over the field, below the project's folder: black grows nothing; empty: none
  std::string heightMap;   ///< the same for the height: black 0, mid grey as it is, white twice
  std::string colourMap;   ///< the same for the colour, times twice its sRGB value: mid grey changes nothing
  std::string extra;

  /// The pictures themselves; null where there is none. Never saved: engine/io reads them (loadAssets).
  std::shared_ptr<const GrassMap> densityPixels, heightPixels, colourPixels;
};

enum class BladeForm {
  Quad,
  Triangle,
  Quadratic,    ///< narrows faster and faster
  TriangleTip,  ///< a strip with a pointed tip
};
enum class BezierWind {
  Field,  ///< the simulated wind
  Waves,  ///< waves that run with the ambient wind, the paper's
  Both,
};

/// What Bezier grass has beside GrassSettings, whose density, measures, stiffness, colours, slopes and maps hold for it
/// as well (Jahrmann & Wimmer, "Responsive real-time grass rendering", 2017; reference/bezier-grass). Forces are given
/// for a blade 1 m high and grow with the height, so that blades of any height bend alike.
struct BezierSettings {
  int most = 1'000'000;  ///< blades on the ground at most: a higher density is lowered, and the blades widened
  // Placement.
  float tufts = 0.35f;       ///< part of the blades that grow in tufts, 0..1
  float tuftSpacing = 0.6f;  ///< m: least distance between tufts (Poisson disk)
  float tuftRadius = 0.12f;  ///< m
  // Shape.
  BladeForm form = BladeForm::TriangleTip;
  float tip = 0.5f;         ///< tau: where along the blade a pointed tip begins, 0..1; triangle-tip
  float dandelions = 0.0f;  ///< part of the blades that are dandelions, 0..1
  float fold = 0.5f;        ///< depth of the "v" cross-section over the paper's (eq. 23), 0..1
  float widthLeast = 1.0f;  ///< pixels: w_min of eq. 24; narrower blades get the width of a quad
  float widthSpan = 2.0f;   ///< pixels: w_span of eq. 24
  // Forces.
  float recovery = 4.0f;                          ///< 1/s: s of eq. 3 for stiffness 1
  glm::vec3 gravityDirection{0.0f, -1.0f, 0.0f};  ///< D_xyz of eq. 4, any length but 0
  float gravity = 1.5f;                           ///< m/s: D_w
  glm::vec3 gravityCentre{0.0f};                  ///< m in the world: C_xyz
  float centreGravity = 1.5f;                     ///< m/s: C_w
  float centreBlend = 0.0f;                       ///< t: 0 along the direction, 1 towards the centre
  float frontGravity = 0.25f;                     ///< part of it that pulls to the front (eq. 5)
  BezierWind wind = BezierWind::Field;
  float windStrength = 0.3f;  ///< m/s of the tip for each m/s of wind
  float waveLength = 14.0f;   ///< m; waves
  float waveSpeed = 6.0f;     ///< m/s: how fast they run; waves
  float waveStrength = 5.0f;  ///< m/s: their wind at the crest; waves
  // Collision.
  float collisionStrength = 2.0f;  ///< gained when its tip is moved by its height within 1/4 s (eq. 16)
  float collisionFade = 0.6f;      ///< a, 1/s: strength lost (eq. 2)
  // Culling, see FrameInput for switching the tests off.
  float orientationLimit = 0.9f;  ///< eq. 17: blades seen more edge-on than this are left out, 0..1; 1: none
  float reach = 120.0f;           ///< m: d_max of eq. 19, 20, where no blade is left
  int distanceLevels = 8;         ///< n of eq. 19, 20
  std::string extra;
};

enum class ShellMethod {
  Filled,  ///< each shell also shows what lies between it and the next below, so that a few do; placed where it matters
  Plain,   ///< the paper's: evenly spaced, each only cuts through the blades, drawn from the ground up
};
enum class ShellWind {
  Field,   ///< the simulated wind
  Source,  ///< swings away from and towards a place, ring after ring, the paper's
  Both,
};
enum class ShellSampling {
  Vertex,  ///< wind at the corners of the shells' triangles
  Texel,   ///< at every pixel, too: finer gusts, dearer
};

/// What shell grass has beside GrassSettings, whose density, measures, stiffness, colours, slopes and maps hold for it
/// as well (Bakay, Lalonde & Heidrich, "Real-time animated grass", 2002; reference/shell-grass).
struct ShellSettings {
  int shells = 8;  ///< over the ground, near the camera; Filled draws fewer of them farther away. 1..128
  ShellMethod method = ShellMethod::Filled;
  // Texture: cuts through blades, repeated over the ground.
  float tile = 4.0f;  ///< m: side of its square on the ground; on surfaces in proportion to the height of their blades
  int texels = 1024;  ///< a side, made a power of two: 64..1024
  float fullness = 4.0f;     ///< blades for each one that the density asks for, since upright ones cover less
  float thickness = 0.7f;    ///< of a blade's cut over its width, 0.05..1
  float taper = 0.6f;        ///< how much of a blade narrows: 0 is as thick at its top as at its root, 1 is a cone
  float heightCurve = 1.5f;  ///< p: height = 1 - (1 - alpha)^p of the tallest; above 1 is finer at the upper end
  std::string texture;       ///< picture to take instead, below the project's folder: height in alpha; empty: none
  // Wind.
  float stiffnessCurve =
      1.0f;               ///< p: at part x of a blade it leans by x^p of what its tip does: < 1 bends low, > 1 high
  float overBend = 1.0f;  ///< intensity at most: 1 lays the tip level, more bends it down to the ground, up to 2
  float lean = 0.35f;     ///< by how much clumps lean in still air, 0..1
  ShellWind wind = ShellWind::Field;
  float windStrength = 1.0f;  ///< over what GrassSettings::windFactor gives
  ShellSampling sampling = ShellSampling::Vertex;
  glm::vec2 source{0.0f, 0.0f};  ///< m: where the paper's wind comes from
  float sourceStrength = 0.6f;   ///< intensity at its crest, 0..2
  float sourcePeriod = 3.0f;     ///< s
  float sourceStep = 1.0f;       ///< m: width of the rings around it that swing alike ("animation steps")
  float sourceDelay = 0.12f;     ///< s that each ring swings later than the one inside it
  std::string extra;

  /// The picture; null where there is none. Never saved: engine/io reads it (loadAssets).
  std::shared_ptr<const GrassMap> pixels;
};

enum class PlantShape {
  Blade,  ///< as the meadow's own, with its own measures and colours
  Daisy,  ///< a stem with a white flower
  Poppy,  ///< a stem with a cup
  Spike,  ///< a stem with flowers along its upper part
  Mesh,   ///< a glTF plant or tuft
};

/// Plants that grow among the meadow's own blades.
struct Species {
  Id id = 0;
  std::string name;
  PlantShape shape = PlantShape::Blade;
  std::string file;              ///< of a mesh: glTF below the project's folder
  float weight = 0.2f;           ///< plants for each of the meadow's own blades; all share GrassSettings::density
  float patchiness = 0.5f;       ///< 0: everywhere alike; 1: only in patches
  float patchSize = 8.0f;        ///< m
  float height = 0.8f;           ///< m
  float heightVariation = 0.3f;  ///< part of the height, 0..1
  float width = 0.02f;           ///< m: of a blade or stem at its base; a mesh keeps its own proportions
  float stiffness = 1.0f;        ///< as GrassSettings
  glm::vec3 baseColour{0.035f, 0.075f, 0.014f};  ///< linear RGB at the root (blade, stem)
  glm::vec3 tipColour{0.30f, 0.42f, 0.085f};     ///< linear RGB at the tip; of a flower's petals; times a mesh's own
  bool hidden = false;
  std::string extra;

  /// Null until read (engine/io) and for shapes without a file. Never saved, not compared.
  std::shared_ptr<const PlantMesh> mesh;
};
bool operator==(const Species& a, const Species& b);

enum class ColliderShape { Sphere, Capsule, Mesh };

/// Where a collider is at a time.
struct ColliderKey {
  float time = 0;          ///< s
  glm::vec3 offset{0.0f};  ///< m from its place: x, height over the ground, z
  bool operator==(const ColliderKey&) const = default;
};

/// A thing that moves through the grass and bends it. Wind doesn't feel it.
struct Collider {
  Id id = 0;
  std::string name;
  ColliderShape shape = ColliderShape::Sphere;
  glm::vec2 position{0.0f, 0.0f};  ///< m
  float lift = 0.0f;               ///< m between its lowest point and the ground
  float radius = 0.5f;             ///< m; sphere and capsule
  float length = 0.3f;             ///< m between the centres of a capsule's ends, which lies level
  float rotation = 0.0f;           ///< deg from +X towards +Z: where capsule and mesh point, while they rest
  std::string file;                ///< of a mesh: glTF below the project's folder
  float scale = 1.0f;              ///< of the mesh
  int spheres = 256;               ///< at most, that stand for the mesh where it meets grass; 1..1024
  std::vector<ColliderKey> keys;   ///< ascending times; none: it rests
  bool loop = true;                ///< begins again after its last key
  bool roll = true;                ///< a sphere turns as it moves
  bool hidden = false, muted = false, locked = false;
  std::string extra;

  /// Null until read (engine/io). Never saved, not compared.
  std::shared_ptr<const PlantMesh> mesh;
};
bool operator==(const Collider& a, const Collider& b);

enum class SurfaceShape {
  Moebius,  ///< a band with one twist; grows on all of its one side
  Torus,
  Sphere,
  Hare,  ///< a sitting animal, closed
  Mesh,  ///< a glTF file
};

/// A thing with grass all over it, upside down as well: Bezier and shell grass grow on it; wind and other grass don't
/// feel it.
struct Surface {
  Id id = 0;
  std::string name;
  SurfaceShape shape = SurfaceShape::Sphere;
  glm::vec2 position{0.0f, 0.0f};          ///< m: of its origin
  float lift = 0.0f;                       ///< m between its lowest point and the ground
  float size = 4.0f;                       ///< m: longest side of a built-in shape
  float rotation = 0.0f;                   ///< deg from +X towards +Z
  float tilt = 0.0f;                       ///< deg about its own x axis, before the rotation
  std::string file;                        ///< of a mesh: glTF below the project's folder
  float scale = 1.0f;                      ///< of the mesh
  float density = 1500.0f;                 ///< blades per m^2
  float height = 0.15f;                    ///< m
  float width = 0.006f;                    ///< m
  float stiffness = 1.0f;                  ///< as GrassSettings
  bool bothSides = false;                  ///< grows on the backs of the triangles, too
  glm::vec3 colour{0.10f, 0.07f, 0.035f};  ///< between the blades, linear RGB
  bool hidden = false, locked = false;
  std::string extra;

  /// Null until read (engine/io) and for built-in shapes. Never saved, not compared.
  std::shared_ptr<const PlantMesh> mesh;
};
bool operator==(const Surface& a, const Surface& b);

/// Air that a rotor above blows down and away from under it, in rings: wind that the flat field can't hold, since it
/// has a source. All grass feels it; it is no part of the simulated field and of exports.
struct Rotor {
  Id id = 0;
  std::string name;
  glm::vec2 position{0.0f, 0.0f};  ///< m
  float lift = 8.0f;               ///< m over the ground
  float radius = 5.0f;             ///< m, of the rotor
  float speed = 16.0f;             ///< m/s: of the air that it throws down
  float rings = 0.6f;              ///< strength of the rings that run outwards, part of the speed, 0..1
  float rate = 0.8f;               ///< rings per second
  bool hidden = false, muted = false, locked = false;
  std::string extra;

  bool operator==(const Rotor&) const = default;
};

/// Blades per m^2 that are drawn: the density, or 0 where there is no grass.
inline float shownDensity(const GrassSettings& grass) {
  return grass.kind == GrassKind::None ? 0.0f : grass.density;
}

/// Height over the ground at which wind trees are drawn and taken hold of, m: most blades end there.
inline float markHeight(const GrassSettings& grass) {
  return grass.kind == GrassKind::None ? 0.0f : 0.8f * grass.height;
}

template <class T>
using Shared = std::shared_ptr<const T>;

struct Project {
  std::string name = "Untitled";
  Shared<FieldSettings> field = std::make_shared<FieldSettings>();
  Shared<SolverSettings> solver = std::make_shared<SolverSettings>();
  Shared<AmbientWind> ambient = std::make_shared<AmbientWind>();
  Shared<WindGraph> graph = std::make_shared<WindGraph>();
  Shared<std::vector<Obstacle>> obstacles = std::make_shared<std::vector<Obstacle>>();
  Shared<TerrainSettings> terrain = std::make_shared<TerrainSettings>();
  Shared<GrassSettings> grass = std::make_shared<GrassSettings>();
  Shared<BezierSettings> bezier = std::make_shared<BezierSettings>();
  Shared<ShellSettings> shell = std::make_shared<ShellSettings>();
  Shared<std::vector<Species>> species = std::make_shared<std::vector<Species>>();
  Shared<std::vector<Collider>> colliders = std::make_shared<std::vector<Collider>>();
  Shared<std::vector<Surface>> surfaces = std::make_shared<std::vector<Surface>>();
  Shared<std::vector<Rotor>> rotors = std::make_shared<std::vector<Rotor>>();
  Shared<std::vector<Probe>> probes = std::make_shared<std::vector<Probe>>();
  Shared<std::vector<Camera>> cameras = std::make_shared<std::vector<Camera>>();
  Shared<std::string> extra = std::make_shared<std::string>();  ///< unknown top-level keys, JSON object text

  /// Same name and same part pointers: nothing was edited between the two.
  [[nodiscard]] bool sameAs(const Project& other) const;
};

/// Ids are unique over points, arrows, obstacles, species, colliders, surfaces, rotors, probes and
/// cameras of one project; 0 is no id.
inline constexpr Id kMaxId = 2147483647;

/// Ids that no record of a project has, which must stay as it is meanwhile: in turn those above every one in use, and
/// where these have come to their end at kMaxId, the lowest ones that are free.
class FreeIds {
 public:
  explicit FreeIds(const Project& project);
  Id take();

 private:
  const Project& m_project;
  Id m_last = 0;            // taken last, or the highest in use
  std::vector<Id> m_used;   // ascending; empty until the highest ids have come to their end
  std::size_t m_place = 0;  // in m_used: all before it are below m_last
};

/// The first of them.
Id nextFreeId(const Project& project);

}  // namespace windloom
