#pragma once
// What the two ways to a context share.

#include <string>
#include <string_view>

namespace windloom::gpu {

/// A renderer string of a known software implementation.
bool isSoftwareRenderer(std::string_view renderer);

/// "RENDERER, OpenGL VERSION" of the current context, for messages.
std::string describeVersion();

}  // namespace windloom::gpu
