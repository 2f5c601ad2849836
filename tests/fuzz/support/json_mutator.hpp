#pragma once
// Mutations of JSON that stay JSON: values become extremes, members and records are doubled, dropped, moved and
// exchanged, ids point elsewhere, words become other words. One in eight mutations is of the plain bytes.

#include <cstdint>
#include <string>
#include <vector>

namespace windloom::fuzz {

/// What the format knows: names of members, and texts that are values.
struct JsonWords {
  std::vector<std::string> keys, values;
};

/// For LLVMFuzzerCustomMutator: changes data[0, size) in place, at most maxSize bytes; the new size.
std::size_t mutateJson(std::uint8_t* data, std::size_t size, std::size_t maxSize, unsigned seed,
                       const JsonWords& words);

/// For LLVMFuzzerCustomCrossOver: the first document with a part of the second; 0 where that can't be.
std::size_t crossJson(const std::uint8_t* first, std::size_t firstSize, const std::uint8_t* second,
                      std::size_t secondSize, std::uint8_t* out, std::size_t maxSize, unsigned seed);

/// The words of project files, from the parameter tables.
const JsonWords& projectWords();

}  // namespace windloom::fuzz
