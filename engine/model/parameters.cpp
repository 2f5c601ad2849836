#include "engine/model/parameters.hpp"

#include <array>

namespace windloom {
namespace {

using Names = std::string_view;
constexpr std::array<Names, 3> kBorders{"open", "wall", "periodic"};
constexpr std::array<Names, 3> kBackends{"auto", "gpu", "cpu"};
constexpr std::array<Names, 2> kAdvections{"maccormack", "semi-lagrangian"};
constexpr std::array<Names, 2> kPressures{"multigrid", "jacobi"};
constexpr std::array<Names, 2> kDrives{"speed", "force"};
constexpr std::array<Names, 2> kWheres{"along", "end"};
constexpr std::array<Names, 4> kSignalKinds{"constant", "pulse", "gusts", "curve"};
constexpr std::array<Names, 3> kObstacleShapes{"circle", "box", "polygon"};
constexpr std::array<Names, 4> kGrassKinds{"instanced", "bezier", "shell", "none"};
constexpr std::array<Names, 3> kTerrainKinds{"flat", "heightmap", "mesh"};
constexpr std::array<Names, 3> kDeformations{"arc", "quadratic", "inertial"};
constexpr std::array<Names, 2> kSources{"solved", "card"};
constexpr std::array<Names, 5> kPlantShapes{"blade", "daisy", "poppy", "spike", "mesh"};
constexpr std::array<Names, 3> kColliderShapes{"sphere", "capsule", "mesh"};

// Within a thousand kilometres of the origin a float still resolves 6 cm.
constexpr double kFar = 1e6;
constexpr int kMaxSeed = 2147483647;

}  // namespace

template <>
std::span<const Parameter<FieldSettings>> parametersOf<FieldSettings>() {
  using F = FieldSettings;
  static constexpr std::array kTable{
      real<&F::centre>("centre", "Centre", "m", -kFar, kFar, 1, "Middle of the wind field in the world (x, z)."),
      real<&F::size>("size", "Size", "m", 1, 100000, 1, "Extent of the wind field along x and z."),
      integer<&F::resolution>("resolution", "Resolution", "cells", 8, 4096, 8,
                              "Cells along x and z; every cell is one group of blades with the same wind."),
      choice<&F::xMin>("borders/xMin", "Border at low x", kBorders,
                       "What the side at low x does with the air; periodic sides come in pairs."),
      choice<&F::xMax>("borders/xMax", "Border at high x", kBorders, "What the side at high x does with the air."),
      choice<&F::zMin>("borders/zMin", "Border at low z", kBorders, "What the side at low z does with the air."),
      choice<&F::zMax>("borders/zMax", "Border at high z", kBorders, "What the side at high z does with the air."),
      real<&F::timeStep>("timeStep", "Time step", "s", 1e-4, 0.25, 0.001, "Length of one step of the simulation.")};
  return kTable;
}

template <>
std::span<const Parameter<SolverSettings>> parametersOf<SolverSettings>() {
  using S = SolverSettings;
  static constexpr std::array kTable{
      choice<&S::source>("source", "Wind", kSources,
                         "Solved from the arrows and the ambient wind, or the calibration card: a known pattern that "
                         "shows whether an export arrives in a game as it should."),
      choice<&S::backend>("backend", "Backend", kBackends,
                          "Where the wind is computed; auto takes the CPU where OpenGL is a software renderer."),
      choice<&S::advection>("advection", "Advection", kAdvections,
                            "How the air carries itself along; MacCormack keeps small swirls alive."),
      choice<&S::pressure>("pressure", "Pressure", kPressures,
                           "How the field is made free of divergence; Jacobi is the plain scheme of the paper."),
      real<&S::divergenceTolerance>("divergenceTolerance", "Divergence tolerance", "", 1e-7, 0.5, 0.0001,
                                    "Multigrid stops when the remaining part of the divergence is below this."),
      integer<&S::maxCycles>("maxCycles", "Most cycles", "", 1, 50, 1, "At most so many multigrid cycles a step."),
      integer<&S::jacobiSweeps>("sweeps", "Jacobi sweeps", "", 1, 1000, 1, "Sweeps of the Jacobi scheme a step."),
      real<&S::confinement>("confinement", "Confinement", "", 0, 2, 0.01,
                            "Gives back the small swirls that the grid smooths away; bounded by the local speed."),
      real<&S::viscosity>("viscosity", "Viscosity", "m^2/s", 0, 100, 0.01, "How strongly the air smooths itself."),
      real<&S::dissipation>("dissipation", "Dissipation", "1/s", 0, 20, 0.01,
                            "How fast the air calms down to the ambient wind."),
      real<&S::maxSpeed>("maxSpeed", "Speed limit", "m/s", 1, 340, 1, "No cell is ever faster than this."),
      integer<&S::seed>("seed", "Seed", "", 0, kMaxSeed, 1, "Another number gives other random gusts.")};
  return kTable;
}

template <>
std::span<const Parameter<AmbientWind>> parametersOf<AmbientWind>() {
  using A = AmbientWind;
  static constexpr std::array kTable{
      real<&A::speed>("speed", "Speed", "m/s", 0, 60, 0.1, "Speed of the wind that blows everywhere."),
      real<&A::direction>("direction", "Direction", "deg", -360, 360, 1,
                          "Where the air goes to: 0 is along +x, 90 along +z."),
      real<&A::gustStrength>("gusts/strength", "Gust strength", "", 0, 2, 0.05,
                             "Amplitude of the travelling gusts as a part of the speed."),
      real<&A::gustSize>("gusts/size", "Gust size", "m", 0.5, 10000, 0.5, "Distance from one gust to the next."),
      real<&A::gustSpeed>("gusts/speed", "Gust speed", "m/s", 0, 100, 0.1,
                          "How fast the gusts travel along the wind's direction.")};
  return kTable;
}

template <>
std::span<const Parameter<Point>> parametersOf<Point>() {
  static constexpr std::array kTable{
      identifier<&Point::id>("id", "Id", "Number that arrows and signals refer to."),
      text<&Point::name>("name", "Name", "Name shown in the outliner."),
      real<&Point::position>("position", "Position", "m", -kFar, kFar, 0.1, "Place on the ground (x, z)."),
      toggle<&Point::root>("root", "Root", "Begins the signal here although arrows lead to this point.")};
  return kTable;
}

template <>
std::span<const Parameter<Arrow>> parametersOf<Arrow>() {
  static constexpr std::array kTable{
      identifier<&Arrow::id>("id", "Id", "Number of the arrow."),
      text<&Arrow::name>("name", "Name", "Name shown in the outliner."),
      identifier<&Arrow::from>("from", "From", "Point where the arrow begins."),
      identifier<&Arrow::to>("to", "To", "Point where the arrow ends."),
      choice<&Arrow::drive>(
          "drive", "Drive", kDrives,
          "Speed draws the air towards the strength in m/s; force accelerates it by the strength in m/s^2."),
      real<&Arrow::strength>("strength", "Strength", "m/s or m/s^2", 0, 100, 0.1, "How strongly the arrow blows."),
      real<&Arrow::radius>("radius", "Radius", "m", 0.05, 1000, 0.1, "How far from the arrow the air is driven."),
      choice<&Arrow::where>("where", "Where", kWheres, "Along the whole arrow, or at its end point only."),
      real<&Arrow::response>("response", "Response", "s", 0.01, 60, 0.01,
                             "Time in which the air takes up the speed; drive speed only."),
      real<&Arrow::swirl>("swirl", "Swirl", "m/s", -100, 100, 0.1,
                          "Wind around the end point; positive turns from +x towards +z."),
      real<&Arrow::travelSpeed>("travelSpeed", "Travel speed", "m/s", 0.1, 1000, 0.5,
                                "How fast the signal passes along this arrow to the next ones."),
      toggle<&Arrow::hidden>("hidden", "Hidden", "Not drawn in the editor."),
      toggle<&Arrow::muted>("muted", "Muted", "Does not blow; still passes the signal on."),
      toggle<&Arrow::locked>("locked", "Locked", "Can't be picked in the viewport.")};
  return kTable;
}

template <>
std::span<const Parameter<Signal>> parametersOf<Signal>() {
  static constexpr std::array kTable{
      identifier<&Signal::root>("root", "Root", "Point that plays the signal."),
      choice<&Signal::kind>("kind", "Kind", kSignalKinds, "The course of the wind's strength over time."),
      real<&Signal::period>("period", "Period", "s", 0.05, 3600, 0.1,
                            "Time from one onset to the next; pulse and looped curve."),
      real<&Signal::on>("on", "On", "s", 0, 3600, 0.1, "Time from the onset to the begin of the release; pulse."),
      real<&Signal::attack>("attack", "Attack", "s", 0.01, 600, 0.05, "Time from nothing to full strength."),
      real<&Signal::release>("release", "Release", "s", 0.01, 600, 0.05, "Time from full strength to nothing; pulse."),
      real<&Signal::delay>("delay", "Delay", "s", 0, 3600, 0.1, "Time before the first onset."),
      real<&Signal::depth>("depth", "Depth", "", 0, 1, 0.05, "How far the strength drops between gusts; gusts."),
      real<&Signal::rate>("rate", "Rate", "1/s", 0.01, 20, 0.05, "Gusts per second; gusts."),
      integer<&Signal::seed>("seed", "Seed", "", 0, kMaxSeed, 1, "Another number gives other gusts; gusts."),
      toggle<&Signal::loop>("loop", "Loop", "Repeats the curve after each period; curve.")};
  return kTable;
}

template <>
std::span<const Parameter<Obstacle>> parametersOf<Obstacle>() {
  using O = Obstacle;
  static constexpr std::array kTable{
      identifier<&O::id>("id", "Id", "Number of the obstacle."),
      text<&O::name>("name", "Name", "Name shown in the outliner."),
      choice<&O::shape>("shape", "Shape", kObstacleShapes, "Outline on the ground."),
      real<&O::centre>("centre", "Centre", "m", -kFar, kFar, 0.1, "Place on the ground (x, z)."),
      real<&O::radius>("radius", "Radius", "m", 0.05, 10000, 0.1, "Radius of a circle."),
      real<&O::size>("size", "Size", "m", 0.05, 20000, 0.1, "Sides of a box, along its own axes."),
      real<&O::rotation>("rotation", "Rotation", "deg", -360, 360, 1, "Turn of a box or polygon from +x towards +z."),
      real<&O::height>("height", "Height", "m", 0, 1000, 0.1, "How high it is drawn; the wind doesn't depend on it."),
      toggle<&O::hidden>("hidden", "Hidden", "Not drawn in the editor."),
      toggle<&O::muted>("muted", "Muted", "Lets the air through."),
      toggle<&O::locked>("locked", "Locked", "Can't be picked in the viewport.")};
  return kTable;
}

template <>
std::span<const Parameter<Probe>> parametersOf<Probe>() {
  static constexpr std::array kTable{
      identifier<&Probe::id>("id", "Id", "Number of the probe."),
      text<&Probe::name>("name", "Name", "Name shown in the outliner and in plots."),
      real<&Probe::position>("position", "Position", "m", -kFar, kFar, 0.1, "Place where the wind is watched (x, z)."),
      toggle<&Probe::hidden>("hidden", "Hidden", "Not drawn in the editor."),
      toggle<&Probe::locked>("locked", "Locked", "Can't be picked in the viewport.")};
  return kTable;
}

template <>
std::span<const Parameter<Camera>> parametersOf<Camera>() {
  static constexpr std::array kTable{
      identifier<&Camera::id>("id", "Id", "Number of the camera."),
      text<&Camera::name>("name", "Name", "Name to render from: windloom render --camera NAME."),
      real<&Camera::position>("position", "Position", "m", -kFar, kFar, 0.1, "Place of the eye (x, y, z)."),
      real<&Camera::target>("target", "Target", "m", -kFar, kFar, 0.1, "Place it looks at (x, y, z)."),
      real<&Camera::fieldOfView>("fieldOfView", "Field of view", "deg", 5, 150, 1, "Vertical opening angle.")};
  return kTable;
}

template <>
std::span<const Parameter<TerrainSettings>> parametersOf<TerrainSettings>() {
  using T = TerrainSettings;
  static constexpr std::array kTable{
      choice<&T::kind>("kind", "Kind", kTerrainKinds,
                       "Shape of the ground: flat, a grey picture (PNG), or a mesh (glTF) seen from above."),
      text<&T::file>("file", "File", "Picture or mesh, below the project's folder; not for flat ground."),
      real<&T::centre>("centre", "Centre", "m", -kFar, kFar, 1,
                       "Middle of the height map, or place of the mesh (x, z)."),
      real<&T::size>("size", "Size", "m", 0.1, 100000, 1, "Extent of the height map along x and z."),
      real<&T::height>("height", "Height", "m", -10000, 10000, 0.1, "How much higher white is than black; height map."),
      real<&T::base>("base", "Base", "m", -10000, 10000, 0.1, "Height of black, or of the mesh's own zero."),
      real<&T::scale>("scale", "Scale", "", 0.0001, 10000, 0.01, "Size of the mesh over what its file says."),
      real<&T::colour>("colour", "Colour", "", 0, 1, 0.01, "Bare ground between the blades, linear RGB.")};
  return kTable;
}

template <>
std::span<const Parameter<GrassSettings>> parametersOf<GrassSettings>() {
  using G = GrassSettings;
  static constexpr std::array kTable{
      choice<&G::kind>("kind", "Kind", kGrassKinds, "How the grass is made and drawn; none leaves the ground bare."),
      real<&G::density>("density", "Density", "1/m^2", 0, 20000, 10, "Blades per square metre."),
      integer<&G::seed>("seed", "Seed", "", 0, kMaxSeed, 1, "Another number gives another meadow."),
      real<&G::height>("height", "Height", "m", 0.01, 10, 0.01, "Mean height of a blade."),
      real<&G::heightVariation>("heightVariation", "Height variation", "", 0, 1, 0.01, "How much heights differ."),
      real<&G::width>("width", "Width", "m", 0.001, 1, 0.001, "Width of a blade at its base."),
      real<&G::stiffness>("stiffness", "Stiffness", "", 0.05, 20, 0.05,
                          "1 is meadow grass; twice as much bends half as far in the same wind."),
      real<&G::stiffnessVariation>("stiffnessVariation", "Stiffness variation", "", 0, 1, 0.01, "How much it differs."),
      real<&G::clumping>("clumping", "Clumping", "", 0, 1, 0.01, "How much neighbours share height, lean and colour."),
      choice<&G::deformation>(
          "deformation", "Deformation", kDeformations,
          "Arc keeps a blade's length and never lies down; quadratic is the paper's; inertial blades overshoot "
          "and settle after a gust."),
      real<&G::windFactor>("windFactor", "Wind factor", "", 0, 1, 0.005, "Bend per m/s of wind."),
      real<&G::droopDown>("droop/down", "Droop down", "", 0, 1, 0.01, "How far a blade sinks by its own weight."),
      real<&G::droopForward>("droop/forward", "Droop forward", "", 0, 1, 0.01, "How far it leans by its own weight."),
      real<&G::restBlend>("restBlend", "Rest blend", "", 0, 1, 0.01,
                          "Part of the rest pose in the bent one; quadratic."),
      real<&G::flutter>("flutter", "Flutter", "", 0, 1, 0.01, "Small motion around the bent pose."),
      real<&G::baseColour>("colours/base", "Base colour", "", 0, 1, 0.01, "Colour at the root, linear RGB."),
      real<&G::tipColour>("colours/tip", "Tip colour", "", 0, 1, 0.01, "Colour at the tip, linear RGB."),
      real<&G::dryColour>("colours/dry", "Dry colour", "", 0, 1, 0.01, "Colour that dry clumps lean to, linear RGB."),
      real<&G::dryness>("dryness", "Dryness", "", 0, 1, 0.01, "Part of the clumps that are dry."),
      real<&G::shadowMin>("shadow/min", "Darkest", "", 0, 1, 0.01, "Darkest shade between the blades."),
      real<&G::shadowMax>("shadow/max", "Brightest", "", 0, 2, 0.01, "Brightest shade."),
      real<&G::shadowWind>("shadow/wind", "Darkening by wind", "", 0, 2, 0.01, "How much bent blades darken."),
      real<&G::shadowOffset>("shadow/offset", "Shade offset", "", -2, 2, 0.01, "Brightness of the root in still air."),
      real<&G::swingRate>("swing/rate", "Swing rate", "Hz", 0.1, 20, 0.1,
                          "Swings per second of a blade that was pushed; inertial, and blades that objects bent."),
      real<&G::swingDamping>("swing/damping", "Swing damping", "", 0.02, 1, 0.01,
                             "How soon swings die out: 1 comes back without passing the rest pose; inertial, and "
                             "blades that objects bent."),
      real<&G::windExponent>("swing/exponent", "Wind exponent", "", 1, 2, 0.01,
                             "How the force on a blade grows with the wind's speed: 2 as on a stiff plate, less for "
                             "blades that give way; inertial."),
      real<&G::slopeAlign>("slope/align", "Slope alignment", "", 0, 1, 0.01,
                           "How far blades lean out of a slope: 0 upright, 1 at right angles to the ground."),
      real<&G::slopeLimit>("slope/limit", "Slope limit", "deg", 0, 90, 1, "No grass on ground steeper than this."),
      integer<&G::interacting>("interacting", "Interacting blades", "", 0, 100'000, 1000,
                               "At most so many blades remember what touched them."),
      text<&G::densityMap>("maps/density", "Density map",
                           "Picture over the field, below the project's folder: black grows nothing, white all of it."),
      text<&G::heightMap>("maps/height", "Height map",
                          "Picture over the field: black is no height, mid grey as it is, white twice."),
      text<&G::colourMap>("maps/colour", "Colour map",
                          "Picture over the field, multiplied with the blades' colour: mid grey changes nothing.")};
  return kTable;
}

template <>
std::span<const Parameter<Species>> parametersOf<Species>() {
  using S = Species;
  static constexpr std::array kTable{
      identifier<&S::id>("id", "Id", "Number of the species."),
      text<&S::name>("name", "Name", "Name shown in the outliner."),
      choice<&S::shape>(
          "shape", "Shape", kPlantShapes,
          "Blade as the meadow's own, daisy, poppy and spike are flowers on a stem, mesh is a glTF file."),
      text<&S::file>("file", "File", "glTF plant or tuft below the project's folder; mesh."),
      real<&S::weight>("weight", "Weight", "", 0, 20, 0.01,
                       "Plants for each of the meadow's own blades; all of them together make up its density."),
      real<&S::patchiness>("patchiness", "Patchiness", "", 0, 1, 0.01, "0 grows everywhere alike, 1 only in patches."),
      real<&S::patchSize>("patchSize", "Patch size", "m", 0.1, 1000, 0.5, "Distance from one patch to the next."),
      real<&S::height>("height", "Height", "m", 0.01, 10, 0.01, "Mean height of a plant."),
      real<&S::heightVariation>("heightVariation", "Height variation", "", 0, 1, 0.01, "How much heights differ."),
      real<&S::width>("width", "Width", "m", 0.001, 1, 0.001,
                      "Width of a blade or stem at its base; a mesh keeps its own proportions."),
      real<&S::stiffness>("stiffness", "Stiffness", "", 0.05, 20, 0.05,
                          "1 is meadow grass; twice as much bends half as far in the same wind."),
      real<&S::baseColour>("colours/base", "Base colour", "", 0, 1, 0.01,
                           "Colour of a blade or stem at the root, linear RGB."),
      real<&S::tipColour>("colours/tip", "Tip colour", "", 0, 1, 0.01,
                          "Colour of a blade's tip or a flower's petals, or over a mesh's own; linear RGB."),
      toggle<&S::hidden>("hidden", "Hidden", "Does not grow.")};
  return kTable;
}

template <>
std::span<const Parameter<Collider>> parametersOf<Collider>() {
  using C = Collider;
  static constexpr std::array kTable{
      identifier<&C::id>("id", "Id", "Number of the collider."),
      text<&C::name>("name", "Name", "Name shown in the outliner."),
      choice<&C::shape>("shape", "Shape", kColliderShapes, "A ball, a lying capsule, or a glTF file's object."),
      real<&C::position>("position", "Position", "m", -kFar, kFar, 0.1, "Place on the ground (x, z)."),
      real<&C::lift>("lift", "Lift", "m", -1000, 1000, 0.05, "From the ground to its lowest point."),
      real<&C::radius>("radius", "Radius", "m", 0.01, 100, 0.05, "Radius of a sphere or capsule."),
      real<&C::length>("length", "Length", "m", 0, 100, 0.05, "Between the centres of a capsule's round ends."),
      real<&C::rotation>("rotation", "Rotation", "deg", -360, 360, 1,
                         "Turn from +x towards +z while it rests; capsule and mesh."),
      text<&C::file>("file", "File", "glTF object below the project's folder; mesh."),
      real<&C::scale>("scale", "Scale", "", 0.0001, 10000, 0.01, "Size of the mesh over what its file says."),
      integer<&C::spheres>("spheres", "Spheres", "", 1, 1024, 1,
                           "At most, that stand for the mesh where it meets grass; mesh."),
      toggle<&C::loop>("loop", "Loop", "Begins again after its last key."),
      toggle<&C::roll>("roll", "Roll", "A sphere turns as it moves."),
      toggle<&C::hidden>("hidden", "Hidden", "Not drawn; it still bends the grass."),
      toggle<&C::muted>("muted", "Muted", "Doesn't bend the grass."),
      toggle<&C::locked>("locked", "Locked", "Can't be picked in the viewport.")};
  return kTable;
}

}  // namespace windloom
