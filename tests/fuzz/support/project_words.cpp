#include <algorithm>

#include "engine/io/project_records.hpp"
#include "engine/model/parameters.hpp"
#include "tests/fuzz/support/json_mutator.hpp"

namespace windloom::fuzz {
namespace {

template <class Owner>
void addWords(JsonWords& words) {
  for (const Parameter<Owner>& parameter : parametersOf<Owner>()) {
    const std::string key(parameter.info.key);
    const std::size_t slash = key.find('/');
    words.keys.push_back(key.substr(0, slash));
    if (slash != key.npos) words.keys.push_back(key.substr(slash + 1));
    for (const std::string_view choice : parameter.info.choices) words.values.emplace_back(choice);
  }
}

template <class... Owners>
JsonWords wordsOf() {
  JsonWords words{{"graph", "points", "arrows", "signals", "keys"}, {"linear", "smooth", "hold", "terrain/hills.png"}};
  for (const std::string_view key : kProjectKeys) words.keys.emplace_back(key);
  (addWords<Owners>(words), ...);
  for (std::vector<std::string>* list : {&words.keys, &words.values}) {
    std::ranges::sort(*list);
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  return words;
}

}  // namespace

const JsonWords& projectWords() {
  static const JsonWords kWords =
      wordsOf<FieldSettings, SolverSettings, AmbientWind, Point, Arrow, Signal, Obstacle, TerrainSettings,
              GrassSettings, BezierSettings, ShellSettings, Species, Collider, Surface, Rotor, Probe, Camera>();
  return kWords;
}

}  // namespace windloom::fuzz
