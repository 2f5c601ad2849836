// What a reader meets where somebody means harm.

#include <cmath>
#include <random>

#include "tests/unit/bake/live_link_fixture.hpp"

namespace windloom {

TEST_F(LiveLinkTest, RefusesObjectsOfAnotherKind) {
  HostileObject object(m_name);
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_OK);
  object.put(WINDLIVE_AT_VERSION, WINDLIVE_VERSION + 1);
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_NEWER_VERSION);
  object.put(WINDLIVE_AT_VERSION, WINDLIVE_VERSION);
  object.put(WINDLIVE_AT_SLOTS, 0u);
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_DAMAGED);
  object.put(WINDLIVE_AT_SLOTS, WINDLIVE_SLOTS);
  object.put(WINDLIVE_AT_SLOT_BYTES, 0xffffffffu);
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_DAMAGED);
  object.put(WINDLIVE_AT_SLOT_BYTES, WINDLIVE_SLOT_BYTES);
  object.cut(WINDLIVE_BYTES - 1);
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_DAMAGED);
  object.cut(10);
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_NO_LIVE_FIELD);
  object.cut(WINDLIVE_BYTES);
  object.write(0, "SOMEBODY");
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_NO_LIVE_FIELD);
}

TEST_F(LiveLinkTest, TakesNoFieldThatMakesNoSense) {
  HostileObject object(m_name);
  LiveField live = LiveField::open(m_name);
  ASSERT_TRUE(live);
  constexpr std::size_t slot = HostileObject::kSlot;
  const std::vector<std::function<void()>> harm = {
      [&] { object.put(slot + WINDLIVE_AT_WIDTH, 513u); },
      [&] { object.put(slot + WINDLIVE_AT_WIDTH, 0u); },
      [&] { object.put(slot + WINDLIVE_AT_HEIGHT, 0x80000004u); },
      [&] { object.put(slot + WINDLIVE_AT_MAX_X, 0.0f); },
      [&] { object.put(slot + WINDLIVE_AT_MIN_Z, std::nanf("")); },
      [&] { object.put(slot + WINDLIVE_AT_MAX_SPEED, -1.0f); },
      [&] { object.put(slot + WINDLIVE_AT_TIME, HUGE_VAL); },
      [&] { object.put(slot + WINDLIVE_SLOT_HEADER_BYTES, 0x7c00u); },
      [&] { object.put(slot + WINDLIVE_AT_SEQUENCE, std::uint64_t{1}); },
      [&] { object.put(slot + WINDLIVE_AT_SEQUENCE, std::uint64_t{10}); },
  };
  for (std::size_t n = 0; n < harm.size(); ++n) {
    object.putField();
    object.put(slot + WINDLIVE_SLOT_HEADER_BYTES, 0u);
    harm[n]();
    EXPECT_EQ(live.update(), 0) << n;
    EXPECT_EQ(live.info().width, 0) << n;
  }
  object.putField();
  object.put(slot + WINDLIVE_SLOT_HEADER_BYTES, 0u);
  EXPECT_EQ(live.update(), 1);
}

TEST_F(LiveLinkTest, SurvivesAnObjectThatIsCutShort) {
  HostileObject object(m_name);
  LiveField live = LiveField::open(m_name);
  ASSERT_TRUE(live);
  object.putField();
  ASSERT_EQ(live.update(), 1);
  object.put(WINDLIVE_AT_NEWEST, std::uint64_t{2});
  object.cut(static_cast<off_t>(WINDLIVE_HEADER_BYTES));
  EXPECT_EQ(live.update(), 0) << "the field's bytes are gone";
  object.cut(0);
  EXPECT_EQ(live.update(), -1);
  EXPECT_EQ(live.sample(1, 1).x, 0.0f);
}

TEST_F(LiveLinkTest, SurvivesRandomBytes) {
  HostileObject object(m_name);
  LiveField live = LiveField::open(m_name);
  ASSERT_TRUE(live);
  std::mt19937 random(11);
  int taken = 0;
  for (int n = 0; n < 20000; ++n) {
    object.putField();
    for (unsigned changes = random() % 3; changes > 0; --changes) {
      object.put(HostileObject::kSlot + 8 + random() % 60, static_cast<unsigned char>(random()));
    }
    // Newest goes up and down, so that each field counts as new.
    object.put(WINDLIVE_AT_NEWEST, std::uint64_t{n % 2 == 0 ? 1u : 5u});
    object.put(HostileObject::kSlot + WINDLIVE_AT_SEQUENCE, std::uint64_t{n % 2 == 0 ? 2u : 10u});
    taken += live.update() == 1 ? 1 : 0;
    const runtime::Velocity v = live.sample(1.3f, 2.7f);
    ASSERT_TRUE(std::isfinite(v.x) && std::isfinite(v.z)) << n;
  }
  EXPECT_GT(taken, 1000);
}

}  // namespace windloom
