// Tables of what Bezier grass needs: its own settings, the surfaces it grows on, the rotors that blow on it.

#include <array>

#include "engine/model/parameters.hpp"

namespace windloom {
namespace {

using Names = std::string_view;
constexpr std::array<Names, 4> kBladeForms{"quad", "triangle", "quadratic", "triangle-tip"};
constexpr std::array<Names, 3> kBezierWinds{"field", "waves", "both"};
constexpr std::array<Names, 5> kSurfaceShapes{"moebius", "torus", "sphere", "hare", "mesh"};

constexpr double kFar = 1e6;

}  // namespace

template <>
std::span<const Parameter<BezierSettings>> parametersOf<BezierSettings>() {
  using B = BezierSettings;
  static constexpr std::array kTable{
      integer<&B::most>("most", "Most blades", "", 1000, 8'000'000, 10'000,
                        "Blades on the ground at most: where the density asks for more, fewer and wider ones grow."),
      real<&B::tufts>("tufts/share", "Tufts", "", 0, 1, 0.01,
                      "Part of the blades that grow in tufts; the others stand singly."),
      real<&B::tuftSpacing>("tufts/spacing", "Tuft spacing", "m", 0.02, 100, 0.01, "Least distance between two tufts."),
      real<&B::tuftRadius>("tufts/radius", "Tuft radius", "m", 0.001, 10, 0.01, "How far a tuft's blades spread."),
      choice<&B::form>("blade/form", "Form", kBladeForms,
                       "Outline of a blade: a strip, a triangle, one that narrows towards the end, or a strip with a "
                       "pointed tip."),
      real<&B::tip>("blade/tip", "Tip start", "", 0, 0.99, 0.01,
                    "Where along the blade the pointed tip begins: 0 at the root; triangle-tip."),
      real<&B::dandelions>("blade/dandelions", "Dandelions", "", 0, 1, 0.001,
                           "Part of the blades that are dandelion heads on a stalk."),
      real<&B::fold>("blade/fold", "Fold", "", 0, 1, 0.01,
                     "How deeply a blade is folded along its middle: 0 is flat, 1 a marked v."),
      real<&B::widthLeast>("narrow/least", "Least width", "px", 0, 20, 0.1,
                           "Blades narrower than this on the screen lose their taper, so that they don't flicker."),
      real<&B::widthSpan>("narrow/span", "Width span", "px", 0.01, 50, 0.1,
                          "Width beyond the least over which blades get their taper back."),
      real<&B::recovery>("recovery", "Recovery", "1/s", 0, 100, 0.1,
                         "How fast blades of stiffness 1 stand up again: higher is quicker and bends less."),
      real<&B::gravityDirection>("gravity/direction", "Gravity direction", "", -1000, 1000, 0.1,
                                 "Where blades are pulled to (x, y, z); only the direction counts."),
      real<&B::gravity>("gravity/strength", "Gravity", "m/s", 0, 100, 0.05, "How strongly blades are pulled that way."),
      real<&B::gravityCentre>("gravity/centre", "Gravity centre", "m", -kFar, kFar, 0.1,
                              "Place in the world that pulls blades to itself (x, y, z)."),
      real<&B::centreGravity>("gravity/centreStrength", "Centre gravity", "m/s", 0, 100, 0.05,
                              "How strongly the centre pulls."),
      real<&B::centreBlend>("gravity/centreBlend", "Towards centre", "", 0, 1, 0.01,
                            "0 pulls along the direction, 1 to the centre."),
      real<&B::frontGravity>("gravity/front", "Forward lean", "", 0, 2, 0.01,
                             "Part of the pull that goes to a blade's front, so that it nods instead of sinking in."),
      choice<&B::wind>("wind/source", "Wind source", kBezierWinds,
                       "The project's wind, waves that run with the ambient wind's direction, or both added."),
      real<&B::windStrength>("wind/strength", "Wind strength", "", 0, 10, 0.01,
                             "How strongly the wind carries blades along: m/s of the tip per m/s of wind."),
      real<&B::waveLength>("wind/waveLength", "Wave length", "m", 0.1, 10000, 0.5,
                           "Distance from one wave to the next; waves."),
      real<&B::waveSpeed>("wind/waveSpeed", "Wave speed", "m/s", 0, 200, 0.1, "How fast the waves run; waves."),
      real<&B::waveStrength>("wind/waveStrength", "Wave wind", "m/s", 0, 200, 0.1, "Wind at a wave's crest; waves."),
      real<&B::collisionStrength>("collision/strength", "Touch memory", "", 0, 100, 0.05,
                                  "How strongly blades remember what pressed them down: higher stay down longer."),
      real<&B::collisionFade>(
          "collision/fade", "Touch fading", "1/s", 0, 20, 0.01,
          "How fast that is forgotten: lower leaves a longer trail; with 0 it stays while time runs on."),
      real<&B::orientationLimit>("culling/orientation", "Edge-on limit", "", 0, 1, 0.01,
                                 "Blades seen more edge-on than this are not drawn: 1 draws all."),
      real<&B::reach>("culling/reach", "Reach", "m", 1, 10000, 1, "Distance at which the last blade is left out."),
      integer<&B::distanceLevels>("culling/levels", "Distance levels", "", 1, 64, 1,
                                  "Steps in which blades get fewer up to the reach.")};
  return kTable;
}

template <>
std::span<const Parameter<Surface>> parametersOf<Surface>() {
  using S = Surface;
  static constexpr std::array kTable{
      identifier<&S::id>("id", "Id", "Number of the surface."),
      text<&S::name>("name", "Name", "Name shown in the outliner."),
      choice<&S::shape>("shape", "Shape", kSurfaceShapes,
                        "A twisted band, a ring, a ball, a sitting hare, or a glTF file's object."),
      real<&S::position>("position", "Position", "m", -kFar, kFar, 0.1, "Place on the ground (x, z)."),
      real<&S::lift>("lift", "Lift", "m", -1000, 1000, 0.05, "From the ground to its lowest point."),
      real<&S::size>("size", "Size", "m", 0.05, 1000, 0.1, "Longest side; all but mesh."),
      real<&S::rotation>("rotation", "Rotation", "deg", -360, 360, 1, "Turn from +x towards +z."),
      real<&S::tilt>("tilt", "Tilt", "deg", -360, 360, 1, "Turn about its own x axis, before the rotation."),
      text<&S::file>("file", "File", "glTF object below the project's folder; mesh."),
      real<&S::scale>("scale", "Scale", "", 0.0001, 10000, 0.01, "Size of the mesh over what its file says."),
      real<&S::density>("density", "Density", "1/m^2", 0, 100'000, 10, "Blades per square metre of its skin."),
      real<&S::height>("height", "Height", "m", 0.001, 10, 0.01, "Mean height of a blade; it differs as the meadow's."),
      real<&S::width>("width", "Width", "m", 0.0001, 1, 0.001, "Width of a blade at its base."),
      real<&S::stiffness>("stiffness", "Stiffness", "", 0.05, 20, 0.05,
                          "1 is meadow grass; twice as much bends half as far in the same wind."),
      toggle<&S::bothSides>("bothSides", "Both sides", "Grows on the backs of the triangles, too."),
      real<&S::colour>("colour", "Colour", "", 0, 1, 0.01, "Skin between the blades, linear RGB."),
      toggle<&S::hidden>("hidden", "Hidden", "Neither it nor its grass is drawn."),
      toggle<&S::locked>("locked", "Locked", "Can't be picked in the viewport.")};
  return kTable;
}

template <>
std::span<const Parameter<Rotor>> parametersOf<Rotor>() {
  using R = Rotor;
  static constexpr std::array kTable{
      identifier<&R::id>("id", "Id", "Number of the rotor."),
      text<&R::name>("name", "Name", "Name shown in the outliner."),
      real<&R::position>("position", "Position", "m", -kFar, kFar, 0.1, "Place on the ground below it (x, z)."),
      real<&R::lift>("lift", "Lift", "m", 0.1, 1000, 0.1, "Height over the ground."),
      real<&R::radius>("radius", "Radius", "m", 0.1, 100, 0.1, "From its middle to the blades' ends."),
      real<&R::speed>("speed", "Speed", "m/s", 0, 100, 0.5, "Of the air that it throws down."),
      real<&R::rings>("rings", "Rings", "", 0, 1, 0.01,
                      "Strength of the rings that run outwards over the grass, as a part of the speed."),
      real<&R::rate>("rate", "Ring rate", "Hz", 0, 20, 0.05, "Rings per second."),
      toggle<&R::hidden>("hidden", "Hidden", "Its mark is not drawn; it still blows."),
      toggle<&R::muted>("muted", "Muted", "Doesn't blow."),
      toggle<&R::locked>("locked", "Locked", "Can't be picked in the viewport.")};
  return kTable;
}

}  // namespace windloom
