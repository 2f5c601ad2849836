#include "tests/fuzz/support/json_mutator.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>

#include "tests/fuzz/support/fuzz_target.hpp"

namespace windloom::fuzz {
namespace {

using Json = nlohmann::ordered_json;
using Random = std::minstd_rand;

constexpr std::size_t kMaxDepth = 80;      // the library writes by recursion
constexpr std::size_t kMaxSpots = 20'000;  // values looked at

/// Put into the text in place of a value: no number of the library's says these.
constexpr std::array<const char*, 10> kRaw{"1e999", "-1e999", "NaN",  "Infinity",   "01",
                                           "1.",    "1e",     "0x10", "1e-9999999", "-"};
constexpr std::string_view kMark = "@raw";

std::size_t below(Random& random, std::size_t count) {
  return count == 0 ? 0 : random() % count;
}
bool chance(Random& random, unsigned oneIn) {
  return random() % oneIn == 0;
}

bool isShallow(std::string_view text) {
  std::size_t depth = 0;
  for (const char c : text) {
    if (c == '[' || c == '{') ++depth;
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (depth > kMaxDepth) return false;
  }
  return true;
}

std::optional<Json> parse(std::string_view text) {
  if (!isShallow(text)) return std::nullopt;
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return std::nullopt;
  return json;
}

struct Spot {
  Json* parent = nullptr;
  Json* value = nullptr;
  std::size_t place = 0;  // in the parent
  std::string key;        // empty in arrays
};

void gather(Json& value, std::vector<Spot>& spots) {
  std::size_t place = 0;
  if (value.is_object()) {
    for (auto& [key, member] : value.get_ref<Json::object_t&>()) {
      if (spots.size() >= kMaxSpots) return;
      spots.push_back({&value, &member, place++, key});
      gather(member, spots);
    }
  } else if (value.is_array()) {
    for (Json& element : value.get_ref<Json::array_t&>()) {
      if (spots.size() >= kMaxSpots) return;
      spots.push_back({&value, &element, place++, {}});
      gather(element, spots);
    }
  }
}

Json extremeNumber(Random& random) {
  static const std::array<Json, 34> kNumbers{0,
                                             -0.0,
                                             1,
                                             -1,
                                             2,
                                             0.5,
                                             -0.5,
                                             0.1,
                                             1e-3,
                                             1e-6,
                                             1e-45,
                                             1.17549435e-38,
                                             3.4e38,
                                             -3.4e38,
                                             3.5e38,
                                             1e308,
                                             -1e308,
                                             4.9e-324,
                                             64,
                                             256,
                                             4096,
                                             8192,
                                             16384,
                                             65536,
                                             1'000'000,
                                             1e7,
                                             16'777'217,
                                             2'147'483'647,
                                             2'147'483'648u,
                                             -2'147'483'648ll,
                                             4'294'967'295u,
                                             4'294'967'296ll,
                                             std::numeric_limits<std::int64_t>::min(),
                                             std::numeric_limits<std::uint64_t>::max()};
  if (chance(random, 12)) return std::string(kMark) + static_cast<char>('0' + below(random, kRaw.size()));
  return kNumbers[below(random, kNumbers.size())];
}

std::string oddText(Random& random, const JsonWords& words) {
  static const std::array<const char*, 12> kTexts{"",       "../outside.png", "/etc/passwd", "a/../../b",
                                                  "a//b",   "C:\\x",          "\x01\x02",    "\xc3\xa9",
                                                  "data:,", "file:///x",      "%2e%2e/x",    "~"};
  switch (below(random, 4)) {
    case 0:
      return std::string(1 + below(random, chance(random, 4) ? 4000 : 300), 'x');
    case 1:
      return kTexts[below(random, kTexts.size())];
    default:
      return words.values.empty() ? "word" : words.values[below(random, words.values.size())];
  }
}

Json nested(Random& random, Json inside) {
  for (std::size_t depth = 1 + below(random, chance(random, 6) ? 70 : 4); depth > 0; --depth) {
    Json around = chance(random, 2) ? Json::array() : Json::object();
    if (around.is_array()) {
      around.push_back(std::move(inside));
    } else {
      around["x"] = std::move(inside);
    }
    inside = std::move(around);
  }
  return inside;
}

Json anyValue(Random& random, const JsonWords& words) {
  switch (below(random, 7)) {
    case 0:
      return nullptr;
    case 1:
      return chance(random, 2);
    case 2:
      return oddText(random, words);
    case 3:
      return Json::array();
    case 4:
      return Json::object();
    case 5:
      return Json::array({extremeNumber(random), extremeNumber(random)});
    default:
      return extremeNumber(random);
  }
}

/// Another value of the same type.
void changeValue(Json& value, Random& random, const JsonWords& words) {
  if (value.is_boolean()) {
    value = !value.get<bool>();
  } else if (value.is_number() && chance(random, 2)) {
    const double number = value.get<double>();
    const std::array<double, 7> near{number + 1, number - 1,    -number,     number * 2,
                                     number / 2, number * 1000, number + 0.5};
    value = near[below(random, near.size())];
  } else if (value.is_number()) {
    value = extremeNumber(random);
  } else if (value.is_string()) {
    value = oddText(random, words);
  } else {
    value = anyValue(random, words);
  }
}

/// Another value that stands under the same name, or is of the same type.
void takeFromElsewhere(const Spot& spot, const std::vector<Spot>& spots, Random& random) {
  std::vector<const Spot*> fitting;
  const auto isId = [](const std::string& key) { return key == "id" || key == "from" || key == "to" || key == "root"; };
  for (const Spot& other : spots) {
    const bool named = !spot.key.empty() && other.key == spot.key;
    const bool ids = isId(spot.key) && isId(other.key);
    if (&other != &spot && (named || ids || (spot.key.empty() && other.value->type() == spot.value->type())))
      fitting.push_back(&other);
  }
  if (fitting.empty()) return;
  Json copy = *fitting[below(random, fitting.size())]->value;
  if (!copy.is_structured() || copy.size() < 200) *spot.value = std::move(copy);
}

void changeArray(Json::array_t& array, std::size_t place, Random& random, const JsonWords& words) {
  const auto at = array.begin() + static_cast<std::ptrdiff_t>(place);
  switch (below(random, 5)) {
    case 0:
      array.erase(at);
      break;
    case 1: {
      const Json copy = *at;
      array.insert(at, 1 + below(random, chance(random, 8) ? 200 : 2), copy);
      break;
    }
    case 2:
      std::swap(*at, array[below(random, array.size())]);
      break;
    case 3:
      std::rotate(array.begin(), at, array.end());
      break;
    default:
      array.insert(at, anyValue(random, words));
  }
}

void changeObject(Json& object, const Spot& spot, Random& random, const JsonWords& words) {
  auto& members = object.get_ref<Json::object_t&>();
  switch (below(random, 5)) {
    case 0:
      members.erase(members.begin() + static_cast<std::ptrdiff_t>(spot.place));
      break;
    case 1: {  // under another name, the old one stays
      const Json copy = *spot.value;
      object[words.keys.empty() ? "x" : words.keys[below(random, words.keys.size())]] = copy;
      break;
    }
    case 2: {
      auto& other = (members.begin() + static_cast<std::ptrdiff_t>(below(random, members.size())))->second;
      if (&other != spot.value) std::swap(*spot.value, other);
      break;
    }
    case 3:
      object[words.keys.empty() || chance(random, 6) ? oddText(random, words)
                                                     : words.keys[below(random, words.keys.size())]] =
          anyValue(random, words);
      break;
    default:
      *spot.value = anyValue(random, words);
  }
}

void mutateOnce(Json& root, Random& random, const JsonWords& words) {
  std::vector<Spot> spots;
  gather(root, spots);
  if (spots.empty()) {
    root = anyValue(random, words);
    return;
  }
  const Spot spot = spots[below(random, spots.size())];
  switch (below(random, 8)) {
    case 0:
    case 1:
    case 2:
      return changeValue(*spot.value, random, words);
    case 3:
      return takeFromElsewhere(spot, spots, random);
    case 4: {
      Json inside = std::move(*spot.value);
      *spot.value = chance(random, 3) ? nested(random, std::move(inside)) : anyValue(random, words);
      return;
    }
    default:
      if (spot.parent->is_array())
        return changeArray(spot.parent->get_ref<Json::array_t&>(), spot.place, random, words);
      return changeObject(*spot.parent, spot, random, words);
  }
}

/// With the marks replaced by what they stand for.
std::string textOf(const Json& json, Random& random) {
  std::string text = json.dump(chance(random, 4) ? 1 : -1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = 0; (at = text.find("\"@raw", at)) != text.npos;) {
    const std::size_t digit = at + 1 + kMark.size();
    if (digit + 1 >= text.size() || text[digit] < '0' || text[digit] > '9' || text[digit + 1] != '"') {
      ++at;
      continue;
    }
    text.replace(at, digit + 2 - at, kRaw[static_cast<std::size_t>(text[digit] - '0')]);
  }
  return text;
}

std::size_t give(const std::string& text, std::uint8_t* out, std::size_t maxSize) {
  if (text.size() > maxSize) return 0;
  std::memcpy(out, text.data(), text.size());
  return text.size();
}

}  // namespace

std::size_t mutateJson(std::uint8_t* data, std::size_t size, std::size_t maxSize, unsigned seed,
                       const JsonWords& words) {
  Random random(seed + 1);
  random.discard(3);
  if (chance(random, 8)) return LLVMFuzzerMutate(data, size, maxSize);
  std::optional<Json> json = parse(asText(data, size));
  if (!json) return LLVMFuzzerMutate(data, size, maxSize);
  for (std::size_t times = 1 + below(random, 4); times > 0; --times) mutateOnce(*json, random, words);
  const std::size_t made = give(textOf(*json, random), data, maxSize);
  return made > 0 ? made : LLVMFuzzerMutate(data, size, maxSize);
}

std::size_t crossJson(const std::uint8_t* first, std::size_t firstSize, const std::uint8_t* second,
                      std::size_t secondSize, std::uint8_t* out, std::size_t maxSize, unsigned seed) {
  std::optional<Json> into = parse(asText(first, firstSize)), from = parse(asText(second, secondSize));
  if (!into || !from) return 0;
  Random random(seed + 1);
  random.discard(3);
  std::vector<Spot> places, parts;
  gather(*into, places);
  gather(*from, parts);
  if (places.empty() || parts.empty()) return 0;
  const Spot& part = parts[below(random, parts.size())];
  std::vector<const Spot*> named;
  for (const Spot& place : places) {
    if (!part.key.empty() && place.key == part.key) named.push_back(&place);
  }
  Json& place = *(named.empty() ? places[below(random, places.size())] : *named[below(random, named.size())]).value;
  place = *part.value;
  return give(textOf(*into, random), out, maxSize);
}

}  // namespace windloom::fuzz
