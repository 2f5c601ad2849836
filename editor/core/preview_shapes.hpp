#pragma once
// What a tool wants drawn over the scene: plain geometry; the viewport gives it colour.

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace windloom::editor {

enum class ShapeRole {
  Preview,  ///< what the gesture will make
  Snap,     ///< the thing it will join to
  Refused,  ///< what it would make is not legal
  Guide,    ///< measures and helper lines
  AxisX,    ///< locked to X
  AxisZ,    ///< locked to Z
};

struct PreviewShapes {
  struct Line {
    glm::vec3 a{0.0f}, b{0.0f};
    ShapeRole role = ShapeRole::Preview;
    bool bold = false;
  };
  /// A ring on the ground.
  struct Disc {
    glm::vec3 centre{0.0f};
    float radius = 1.0f;
    ShapeRole role = ShapeRole::Preview;
    bool bold = false;
  };
  struct Arrow {
    glm::vec3 from{0.0f}, to{0.0f};
    float radius = 1.0f;
    ShapeRole role = ShapeRole::Preview;
  };
  /// A handle of fixed screen size.
  struct Dot {
    glm::vec3 at{0.0f};
    ShapeRole role = ShapeRole::Preview;
  };
  /// A handle of fixed screen size to drag by; `hot` under the pointer.
  enum class GripForm { Square, Round, Tip };
  struct Grip {
    glm::vec3 at{0.0f};
    glm::vec3 from{0.0f};  ///< Tip: where its line comes from
    GripForm form = GripForm::Square;
    ShapeRole role = ShapeRole::Preview;
    bool hot = false;
    std::string name = {};  ///< for tests that look for it on the screen: "grip:radius"
  };
  /// A rectangle in pixels of the viewport (box select).
  struct Rectangle {
    glm::vec2 low{0.0f}, high{0.0f};
  };
  /// Text beside the pointer or a place, in pixels of the viewport.
  struct Label {
    glm::vec2 pixel{0.0f};
    std::string text;
  };

  std::vector<Line> lines;
  std::vector<Disc> discs;
  std::vector<Arrow> arrows;
  std::vector<Dot> dots;
  std::vector<Grip> grips;
  std::vector<Rectangle> rectangles;
  std::vector<Label> labels;
};

}  // namespace windloom::editor
