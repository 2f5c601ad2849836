#pragma once
// Numbers as the bytes of a file.

#include <bit>
#include <string>

namespace windloom {

static_assert(std::endian::native == std::endian::little, "numbers go to files as they lie in memory");

template <class Number>
void appendNumber(std::string& bytes, Number value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// The numbers behind each other, each of its own type's size.
template <class... Numbers>
std::string numberBytes(Numbers... values) {
  std::string bytes;
  (appendNumber(bytes, values), ...);
  return bytes;
}

}  // namespace windloom
