#include "editor/core/object_edits.hpp"
#include "editor_bench.hpp"

namespace windloom::editor {
namespace {

/// Three probes, ids in `ids`.
struct Probes : Bench {
  std::vector<Id> ids;
  Probes() {
    key("P");
    for (const float x : {-10.0f, 0.0f, 10.0f}) click({x, 20});
    for (const Probe& probe : *project().probes) ids.push_back(probe.id);
  }
  [[nodiscard]] std::vector<Id> order() const {
    std::vector<Id> found;
    for (const Probe& probe : *project().probes) found.push_back(probe.id);
    return found;
  }
};

TEST(ReorderEdit, IsOneStepThatUndoes) {
  Probes b;
  const std::vector<Id> last{b.ids[2]};
  EXPECT_TRUE(b.w.apply(reorderEdit(b.project(), last, b.ids[0])));
  EXPECT_EQ(b.order(), (std::vector<Id>{b.ids[2], b.ids[0], b.ids[1]}));
  EXPECT_EQ(b.steps(), 4u);
  b.key("Ctrl+Z");
  EXPECT_EQ(b.order(), b.ids);
  b.key("Ctrl+Y");
  EXPECT_EQ(b.order(), (std::vector<Id>{b.ids[2], b.ids[0], b.ids[1]}));
}

TEST(ReorderEdit, HasNoStepWhereNothingMoves) {
  Probes b;
  EXPECT_TRUE(reorderEdit(b.project(), std::vector<Id>{b.ids[0]}, b.ids[1]).steps.empty());
  EXPECT_TRUE(reorderEdit(b.project(), std::vector<Id>{b.ids[2]}, 0).steps.empty());
  EXPECT_TRUE(reorderEdit(b.project(), std::vector<Id>{b.ids[1]}, b.ids[1]).steps.empty());
  EXPECT_TRUE(reorderEdit(b.project(), std::vector<Id>{999}, b.ids[0]).steps.empty());
}

TEST(ReorderEdit, KeepsTheWindOfTheTree) {
  Bench b;
  b.draw({-20, 0}, {0, 0});
  b.drag({0, 0}, {10, 10});
  b.drag({0, 0}, {10, -10});
  const std::vector<Arrow> before = b.graph().arrows;
  ASSERT_EQ(before.size(), 3u);
  EXPECT_TRUE(b.w.apply(reorderEdit(b.project(), std::vector<Id>{before[2].id}, before[1].id)));
  EXPECT_EQ(b.graph().arrows[1], before[2]);
  EXPECT_EQ(b.graph().arrows[2], before[1]);
  EXPECT_EQ(b.graph().points.size(), 4u);
}

TEST(SelectTool, ADragOnAPointOfASelectedArrowMovesThePoint) {
  Bench b;
  const Id id = b.draw({-20, 0}, {0, 0});
  b.key("Q");
  b.w.selection.replace(id);
  b.drag({0, 0}, {5, 5});
  expectNear(b.place(b.arrow(id).to), {5, 5}, 0.02f);
  expectNear(b.place(b.arrow(id).from), {-20, 0}, 0.02f);
}

}  // namespace
}  // namespace windloom::editor
