#pragma once
// GLFW's keys as the editor's.

#include "editor/app/input_queue.hpp"
#include "editor/core/shortcut.hpp"

namespace windloom::editor {

/// By what is printed on the key in the user's layout where that is a Latin letter, digit or sign (Ctrl+Z is
/// where the user's Z is), else by its place.
Key translateKey(int glfwKey, int scancode);
Modifiers translateModifiers(int glfwModifiers);

}  // namespace windloom::editor
