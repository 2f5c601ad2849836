// What libFuzzer calls to change an input, for targets whose whole input is a project's JSON.

#include <cstdint>

#include "tests/fuzz/support/fuzz_target.hpp"
#include "tests/fuzz/support/json_mutator.hpp"

using namespace windloom;

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned seed) {
  return fuzz::mutateJson(data, size, maxSize, seed, fuzz::projectWords());
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* first, std::size_t firstSize,
                                                 const std::uint8_t* second, std::size_t secondSize, std::uint8_t* out,
                                                 std::size_t maxSize, unsigned seed) {
  return fuzz::crossJson(first, firstSize, second, secondSize, out, maxSize, seed);
}
