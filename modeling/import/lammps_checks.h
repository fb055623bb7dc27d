#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "modeling/import/lammps_data.h"

namespace modeling {

/// Which node has which id; nodes are numbered as they are added.
class LammpsIds {
 public:
  void add(std::int64_t id) { ids_.push_back({id, static_cast<std::uint32_t>(ids_.size())}); }
  std::size_t size() const { return ids_.size(); }
  /// Has to be called before anything is asked.
  void sort();

  std::optional<std::uint32_t> nodeOf(std::int64_t id) const;
  struct Entry {
    std::int64_t id = 0;
    std::uint32_t node = 0;
    auto operator<=>(const Entry&) const = default;
  };
  /// The second of two entries with one id.
  std::optional<Entry> givenTwice() const;

 private:
  std::vector<Entry> ids_;
};

/// Two nodes that are in one place, the lower one first; nothing where there are none.
std::optional<std::pair<std::uint32_t, std::uint32_t>> twoInOnePlace(const std::vector<sim::Vec3>& positions);

/// The later of two bonds between the same nodes.
std::optional<LammpsBond> secondOfPair(const std::vector<LammpsBond>& bonds);

}  // namespace modeling
