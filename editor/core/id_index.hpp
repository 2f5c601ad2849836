#pragma once
// All ids of a project at once: one pass to build, constant time to ask. For work on many ids, where
// searching each one would be quadratic.

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "editor/core/object_kind.hpp"

namespace windloom::editor {

class IdIndex {
 public:
  struct Place {
    ObjectKind kind = ObjectKind::Point;
    std::uint32_t index = 0;  ///< in the vector of its kind
  };

  explicit IdIndex(const Project& project);

  [[nodiscard]] std::optional<Place> find(Id id) const;
  [[nodiscard]] bool contains(Id id) const { return m_places.contains(id); }
  /// The record, or null. Valid as long as the project's parts.
  [[nodiscard]] const Point* point(Id id) const;
  [[nodiscard]] const Arrow* arrow(Id id) const;
  [[nodiscard]] const Obstacle* obstacle(Id id) const;
  [[nodiscard]] const Species* species(Id id) const;
  [[nodiscard]] const Collider* collider(Id id) const;
  [[nodiscard]] const Surface* surface(Id id) const;
  [[nodiscard]] const Rotor* rotor(Id id) const;
  [[nodiscard]] const Probe* probe(Id id) const;
  [[nodiscard]] const Camera* camera(Id id) const;

 private:
  template <class T>
  const T* record(Id id, ObjectKind kind, const std::vector<T>& records) const;
  Project m_project;  // keeps the parts alive
  std::unordered_map<Id, Place> m_places;
};

}  // namespace windloom::editor
