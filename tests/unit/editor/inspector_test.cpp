#include "editor/core/inspector.hpp"

#include "editor/core/refusal.hpp"
#include "editor_bench.hpp"

namespace windloom::editor {
namespace {

const InspectorRow& row(const InspectorSection& section, std::string_view key) {
  for (const InspectorRow& candidate : section.rows) {
    if (candidate.info.key == key) return candidate;
  }
  ADD_FAILURE() << "no row " << key;
  return section.rows.front();
}

struct Pair : Bench {
  Id a = 0, b = 0;
  Pair() {
    a = draw({-20, 0}, {0, 0});
    b = draw({0, 0}, {10, 5});
  }
  [[nodiscard]] InspectorTarget arrows() const { return {InspectorKind::Arrow, {a, b}}; }
};

}  // namespace

TEST(Inspector, SectionsFollowTheSelection) {
  Pair p;
  const std::vector<Id> ids{p.a, p.arrow(p.a).from};
  const auto sections = inspectSelection(p.project(), ids);
  ASSERT_EQ(sections.size(), 3u);
  EXPECT_EQ(sections[0].target.kind, InspectorKind::Point);
  EXPECT_EQ(sections[1].target.kind, InspectorKind::Arrow);
  EXPECT_EQ(sections[2].target.kind, InspectorKind::Signal);
  EXPECT_EQ(sections[2].target.ids, std::vector<Id>{p.arrow(p.a).from});
  // A branch plays the signal of the root that reaches it.
  const auto branch = inspectSelection(p.project(), std::vector<Id>{p.b});
  ASSERT_EQ(branch.size(), 2u);
  EXPECT_EQ(branch[1].target.ids, std::vector<Id>{p.arrow(p.a).from});
  EXPECT_TRUE(inspectSelection(p.project(), {}).empty());
}

TEST(Inspector, DifferentValuesShowAsMixedAndAnEditSetsAll) {
  Pair p;
  p.w.apply(setParameter(p.project(), {InspectorKind::Arrow, {p.b}}, "radius", 9.0f));
  InspectorSection section = inspect(p.project(), p.arrows());
  EXPECT_EQ(section.title, "2 arrows");
  EXPECT_TRUE(row(section, "radius").mixed);
  EXPECT_FALSE(row(section, "strength").mixed);
  p.w.apply(setParameter(p.project(), p.arrows(), "radius", 2.5f));
  section = inspect(p.project(), p.arrows());
  EXPECT_FALSE(row(section, "radius").mixed);
  EXPECT_FLOAT_EQ(std::get<float>(row(section, "radius").value), 2.5f);
}

TEST(Inspector, SlidingIsOneStepUntilItIsSealed) {
  Pair p;
  const std::size_t before = p.steps();
  for (const float value : {5.0f, 6.0f, 7.0f}) {
    EXPECT_TRUE(p.w.apply(setParameter(p.project(), p.arrows(), "strength", value)));
  }
  EXPECT_EQ(p.steps(), before + 1);
  p.w.document.seal();
  EXPECT_TRUE(p.w.apply(setParameter(p.project(), p.arrows(), "strength", 8.5f)));
  EXPECT_EQ(p.steps(), before + 2);
  p.w.undo();
  EXPECT_FLOAT_EQ(p.arrow(p.a).strength, 7.0f);
  p.w.undo();
  EXPECT_FLOAT_EQ(p.arrow(p.b).strength, 8.0f);
}

TEST(Inspector, SettingTheSameValueIsNoStep) {
  Pair p;
  const Result<Edit> edit = setParameter(p.project(), p.arrows(), "strength", p.arrow(p.a).strength);
  ASSERT_TRUE(edit);
  EXPECT_TRUE(edit->steps.empty());
}

TEST(Inspector, IllegalValuesAreRefusedWithTheRange) {
  Pair p;
  for (const ParameterValue& value :
       {ParameterValue(-1.0f), ParameterValue(1e9f), ParameterValue(std::nanf("")), ParameterValue(3)}) {
    const Result<Edit> edit = setParameter(p.project(), p.arrows(), "radius", value);
    ASSERT_FALSE(edit);
    EXPECT_NE(edit.error().text().find("Radius: "), std::string::npos) << edit.error().text();
    EXPECT_EQ(refusalText(edit.error()), edit.error().problems.front().message);
    EXPECT_NE(edit.error().text().find("expected a number from"), std::string::npos) << edit.error().text();
  }
  EXPECT_FALSE(setParameter(p.project(), p.arrows(), "nonsense", 1.0f));
}

TEST(Inspector, TypedTextTakesArithmeticUnitsAndNames) {
  Pair p;
  EXPECT_TRUE(p.w.apply(setFromText(p.project(), p.arrows(), "strength", "2*3+1 m/s")));
  EXPECT_FLOAT_EQ(p.arrow(p.a).strength, 7.0f);
  EXPECT_TRUE(p.w.apply(setFromText(p.project(), p.arrows(), "strength", "4 m/s^2")));
  EXPECT_FLOAT_EQ(p.arrow(p.a).strength, 4.0f);
  EXPECT_TRUE(p.w.apply(setFromText(p.project(), p.arrows(), "drive", "Force")));
  EXPECT_EQ(p.arrow(p.b).drive, Drive::Force);
  EXPECT_TRUE(p.w.apply(setFromText(p.project(), p.arrows(), "muted", "on")));
  EXPECT_TRUE(p.arrow(p.b).muted);
  const InspectorTarget field{InspectorKind::Field};
  EXPECT_TRUE(p.w.apply(setFromText(p.project(), field, "resolution", "2*128, 64")));
  EXPECT_EQ(p.project().field->resolution, glm::ivec2(256, 64));
  EXPECT_FALSE(setFromText(p.project(), field, "resolution", "10.5, 64"));
  EXPECT_FALSE(setFromText(p.project(), field, "resolution", "64"));
  EXPECT_FALSE(setFromText(p.project(), p.arrows(), "drive", "sideways"));
  EXPECT_FALSE(setFromText(p.project(), p.arrows(), "strength", "strong"));
}

TEST(Inspector, OneComponentIsSetAndTheOthersStay) {
  Pair p;
  const InspectorTarget points{InspectorKind::Point, {p.arrow(p.a).from, p.arrow(p.b).to}};
  const InspectorSection section = inspect(p.project(), points);
  EXPECT_TRUE(row(section, "position").mixedComponent[0]);
  EXPECT_TRUE(p.w.apply(setFromText(p.project(), points, "position", "12", 1)));
  expectNear(p.place(p.arrow(p.a).from), {-20, 12});
  expectNear(p.place(p.arrow(p.b).to), {10, 12});
  EXPECT_FALSE(row(inspect(p.project(), points), "position").mixedComponent[1]);
}

TEST(Inspector, ResetGoesBackToTheDefault) {
  Pair p;
  p.w.apply(setParameter(p.project(), p.arrows(), "radius", 9.0f));
  p.w.apply(resetParameter(p.project(), p.arrows(), "radius"));
  EXPECT_FLOAT_EQ(p.arrow(p.a).radius, Arrow{}.radius);
  const InspectorTarget ambient{InspectorKind::Ambient};
  p.w.apply(setParameter(p.project(), ambient, "speed", 5.0f));
  EXPECT_FLOAT_EQ(p.project().ambient->speed, 5.0f);
  p.w.apply(resetParameter(p.project(), ambient, "speed"));
  EXPECT_FLOAT_EQ(p.project().ambient->speed, 0.0f);
}

TEST(Inspector, SignalOfARootThatHasNoneIsMade) {
  Pair p;
  const Id root = p.arrow(p.a).from;
  const InspectorTarget signal{InspectorKind::Signal, {root}};
  EXPECT_EQ(toText(row(inspect(p.project(), signal), "kind").info, row(inspect(p.project(), signal), "kind").value),
            "constant");
  EXPECT_TRUE(p.graph().signals.empty());
  EXPECT_TRUE(p.w.apply(setFromText(p.project(), signal, "kind", "pulse")));
  ASSERT_EQ(p.graph().signals.size(), 1u);
  EXPECT_EQ(p.graph().signals[0].root, root);
  EXPECT_EQ(p.graph().signals[0].kind, SignalKind::Pulse);
}

TEST(Inspector, RowsWithoutEffectAreMarked) {
  Pair p;
  EXPECT_TRUE(row(inspect(p.project(), p.arrows()), "response").relevant);
  p.w.apply(setFromText(p.project(), p.arrows(), "drive", "force"));
  EXPECT_FALSE(row(inspect(p.project(), p.arrows()), "response").relevant);
  EXPECT_FALSE(row(inspect(p.project(), p.arrows()), "from").editable);
}

TEST(Inspector, EverySettingsPartHasRowsThatCanBeSetToThemselves) {
  const Project project;
  for (const InspectorKind kind :
       {InspectorKind::Field, InspectorKind::Solver, InspectorKind::Ambient, InspectorKind::Terrain,
        InspectorKind::Grass, InspectorKind::Bezier, InspectorKind::Shell}) {
    const InspectorSection section = inspect(project, {kind});
    EXPECT_FALSE(section.rows.empty());
    for (const InspectorRow& r : section.rows) {
      EXPECT_EQ(r.value, r.defaultValue) << r.info.key;
      const Result<Edit> edit = setFromText(project, {kind}, r.info.key, toText(r.info, r.value));
      ASSERT_TRUE(edit) << r.info.key << edit.error().text();
      EXPECT_TRUE(edit->steps.empty()) << r.info.key;
    }
  }
}

TEST(Refusal, NamesTheThingInsteadOfThePlaceInTheFile) {
  EXPECT_EQ(refusalText(makeError(ErrorKind::BadInput, "", "/graph/arrows/3/radius", "found -1, expected more")),
            "The arrow's radius: found -1, expected more");
  EXPECT_EQ(refusalText(makeError(ErrorKind::BadInput, "", "/graph/arrows/3", "has no length")),
            "The arrow has no length");
  EXPECT_EQ(refusalText(makeError(ErrorKind::BadInput, "", "/obstacles/0/points", "has sides that cross")),
            "The obstacle's outline has sides that cross");
  EXPECT_EQ(refusalText(makeError(ErrorKind::BadInput, "disk is full")), "disk is full");
  Error error = makeError(ErrorKind::BadInput, "", "/field/borders/xMin", "is not periodic");
  error.problems.push_back(error.problems.front());
  EXPECT_EQ(refusalText(error), "The field's borders xMin is not periodic (and 1 more problem)");
}

}  // namespace windloom::editor
