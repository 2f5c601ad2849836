#pragma once
// Where the record with an id stands in its list. Ids of a project are handed out in sequence, so a
// table by id is both small and several times faster than hashing; a file with wild ids gets a sorted list.

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "engine/model/wind_graph.hpp"

namespace windloom {

class IdIndex {
 public:
  IdIndex() = default;

  /// `idOf(record)` gives a record's id; of records with the same id the first counts.
  template <class Records, class IdOf>
  IdIndex(const Records& records, IdOf&& idOf) {
    Id highest = 0;
    for (const auto& record : records) highest = std::max<Id>(highest, idOf(record));
    const std::size_t count = records.size();
    if (highest <= kSpread * count + kSlack) {
      m_table.assign(std::size_t{highest} + 1, kNone);
      for (std::size_t i = count; i-- > 0;) m_table[idOf(records[i])] = static_cast<std::uint32_t>(i);
    } else {
      for (std::size_t i = 0; i < count; ++i) m_sorted.emplace_back(idOf(records[i]), static_cast<std::uint32_t>(i));
      std::ranges::sort(m_sorted);
    }
  }

  template <class Records>
  explicit IdIndex(const Records& records) : IdIndex(records, [](const auto& record) { return record.id; }) {}

  [[nodiscard]] std::optional<std::uint32_t> find(Id id) const {
    if (id < m_table.size()) return m_table[id] == kNone ? std::nullopt : std::optional(m_table[id]);
    const auto place = std::ranges::lower_bound(m_sorted, id, {}, &std::pair<Id, std::uint32_t>::first);
    if (place == m_sorted.end() || place->first != id) return std::nullopt;
    return place->second;
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  static constexpr std::size_t kSpread = 8, kSlack = 4096;

  std::vector<std::uint32_t> m_table;
  std::vector<std::pair<Id, std::uint32_t>> m_sorted;
};

}  // namespace windloom
