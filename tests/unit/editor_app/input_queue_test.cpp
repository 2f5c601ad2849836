#include "editor/app/input_queue.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace windloom::editor {
namespace {

using Kind = InputEvent::Kind;

InputEvent move(double x, double y) {
  return {.kind = Kind::MouseMove, .x = x, .y = y};
}
InputEvent button(int action) {
  return {.kind = Kind::MouseButton, .code = GLFW_MOUSE_BUTTON_LEFT, .action = action};
}
InputEvent key(int code, int action, int modifiers = 0) {
  return {.kind = Kind::Key, .code = code, .action = action, .modifiers = modifiers};
}
InputEvent text(char c) {
  return {.kind = Kind::Text, .code = c};
}

/// The kinds of the events of each frame until the queue is empty.
std::vector<std::vector<Kind>> frames(InputQueue& queue, bool typing = false) {
  std::vector<std::vector<Kind>> all;
  while (!queue.empty()) {
    std::vector<Kind> kinds;
    for (const InputEvent& event : queue.takeFrame(false, typing)) kinds.push_back(event.kind);
    all.push_back(kinds);
    if (kinds.empty()) break;  // a queue that gives nothing would never end
  }
  return all;
}

TEST(InputQueue, ClickWithinOneFrameIsSeenAsPressAndRelease) {
  InputQueue queue;
  for (const InputEvent& event : {move(10, 10), button(GLFW_PRESS), button(GLFW_RELEASE)}) queue.push(event);
  EXPECT_EQ(frames(queue), (std::vector<std::vector<Kind>>{{Kind::MouseMove, Kind::MouseButton}, {Kind::MouseButton}}));
}

TEST(InputQueue, DragWithinOneFrameBeginsWhereItWasPressed) {
  InputQueue queue;
  for (const InputEvent& event : {move(1, 1), button(GLFW_PRESS), move(50, 50), move(90, 90), button(GLFW_RELEASE)})
    queue.push(event);
  const auto first = queue.takeFrame(false, false);
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[0].x, 1);
  EXPECT_EQ(first[1].action, GLFW_PRESS);
  const auto second = queue.takeFrame(false, false);
  ASSERT_EQ(second.size(), 3u);
  EXPECT_EQ(second[1].x, 90);
  EXPECT_EQ(second[2].action, GLFW_RELEASE);
}

TEST(InputQueue, KeyTappedWithinOneFrameIsSeen) {
  InputQueue queue;
  queue.push(key(GLFW_KEY_ENTER, GLFW_PRESS));
  queue.push(key(GLFW_KEY_ENTER, GLFW_RELEASE));
  EXPECT_EQ(frames(queue).size(), 2u);
}

TEST(InputQueue, EnterDoesNotOvertakeTheTextBeforeIt) {
  InputQueue queue;
  for (const InputEvent& event : {text('1'), text('2'), key(GLFW_KEY_ENTER, GLFW_PRESS)}) queue.push(event);
  EXPECT_EQ(frames(queue), (std::vector<std::vector<Kind>>{{Kind::Text, Kind::Text}, {Kind::Key}}));
}

TEST(InputQueue, TextDoesNotOvertakeTheKeyThatEditsBeforeIt) {
  InputQueue queue;
  for (const InputEvent& event : {key(GLFW_KEY_BACKSPACE, GLFW_PRESS), text('7')}) queue.push(event);
  EXPECT_EQ(frames(queue), (std::vector<std::vector<Kind>>{{Kind::Key}, {Kind::Text}}));
}

TEST(InputQueue, AWordIsTypedInOneFrame) {
  InputQueue queue;
  for (const char letter : {'A', 'a', 'a'}) {
    const int shift = letter == 'A' ? GLFW_MOD_SHIFT : 0;
    if (shift) queue.push(key(GLFW_KEY_LEFT_SHIFT, GLFW_PRESS));
    queue.push(key(GLFW_KEY_A, GLFW_PRESS, shift));
    queue.push(text(letter));
    queue.push(key(GLFW_KEY_A, GLFW_RELEASE, shift));
    if (shift) queue.push(key(GLFW_KEY_LEFT_SHIFT, GLFW_RELEASE, shift));
  }
  queue.push(key(GLFW_KEY_ENTER, GLFW_PRESS));
  queue.push(key(GLFW_KEY_ENTER, GLFW_RELEASE));
  InputQueue elsewhere = queue;
  EXPECT_GT(frames(elsewhere).size(), 4u) << "where no text field has the keyboard each press is a shortcut's";
  const auto typed = frames(queue, true);
  ASSERT_EQ(typed.size(), 3u);
  EXPECT_EQ(std::count(typed[0].begin(), typed[0].end(), Kind::Text), 3);
  EXPECT_EQ(typed[1], std::vector{Kind::Key});
}

TEST(InputQueue, WhatFollowsAnEditingKeyWaitsWhileTyping) {
  InputQueue queue;  // Return closes the field, and D is a shortcut then
  for (const int code : {GLFW_KEY_ENTER, GLFW_KEY_D}) {
    queue.push(key(code, GLFW_PRESS));
    queue.push(key(code, GLFW_RELEASE));
  }
  EXPECT_EQ(queue.takeFrame(false, true).size(), 1u);
  EXPECT_EQ(queue.takeFrame(false, false).size(), 2u) << "the release of Return and the press of D";
}

TEST(InputQueue, ShortcutIsAloneWithItsModifier) {
  InputQueue queue;
  for (const InputEvent& event :
       {key(GLFW_KEY_LEFT_CONTROL, GLFW_PRESS), key(GLFW_KEY_Z, GLFW_PRESS, GLFW_MOD_CONTROL),
        key(GLFW_KEY_Z, GLFW_RELEASE, GLFW_MOD_CONTROL), key(GLFW_KEY_LEFT_CONTROL, GLFW_RELEASE)})
    queue.push(event);
  const auto all = frames(queue);
  ASSERT_GE(all.size(), 2u);
  EXPECT_EQ(all[0].size(), 2u) << "the release of Ctrl must come in a later frame than its Z";
}

TEST(InputQueue, HoldsKeysWhileTheFieldForThemIsNotThere) {
  InputQueue queue;
  for (const InputEvent& event : {move(3, 3), key(GLFW_KEY_D, GLFW_PRESS), text('d')}) queue.push(event);
  EXPECT_EQ(queue.takeFrame(true, false).size(), 1u);
  EXPECT_TRUE(queue.takeFrame(true, false).empty());
  EXPECT_EQ(queue.takeFrame(false, false).size(), 2u);
}

TEST(InputQueue, LossOfFocusComesBeforeTheReleasesItCauses) {
  InputQueue queue;
  queue.push({.kind = Kind::Focus, .action = 0});
  queue.push(button(GLFW_RELEASE));
  EXPECT_EQ(frames(queue), (std::vector<std::vector<Kind>>{{Kind::Focus}, {Kind::MouseButton}}));
}

}  // namespace
}  // namespace windloom::editor
