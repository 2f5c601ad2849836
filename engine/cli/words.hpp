#pragma once
// Numbers and counts as messages have them.

#include <cstdint>
#include <string>
#include <string_view>

namespace windloom::cli {

/// The shortest decimal that reads back as the same number, without an exponent: "1000000", "0.000001".
std::string plain(float value);
std::string plain(double value);

/// "1 frame", "2 frames"; `many` where the plural isn't made by an s.
std::string counted(std::uint64_t count, std::string_view one, std::string_view many = {});

}  // namespace windloom::cli
