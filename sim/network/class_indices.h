#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace sim {

/// Which class each bond is of: two bytes a bond, and four only where there are more classes than those can
/// name. In a body of half a million nodes that is 25 bytes a node.
class ClassIndices {
 public:
  ClassIndices() = default;
  explicit ClassIndices(const std::vector<std::uint32_t>& indices) {
    reserve(indices.size());
    for (const std::uint32_t index : indices) push_back(index);
  }

  std::size_t size() const { return wide_.empty() ? narrow_.size() : wide_.size(); }
  std::uint32_t operator[](std::size_t bond) const { return wide_.empty() ? narrow_[bond] : wide_[bond]; }

  void reserve(std::size_t count) { narrow_.reserve(count); }
  void push_back(std::uint32_t index) {
    if (!fits(index)) widen();
    if (isWide(index)) {
      wide_.push_back(index);
    } else {
      narrow_.push_back(static_cast<std::uint16_t>(index));
    }
  }
  void set(std::size_t bond, std::uint32_t index) {
    if (!fits(index)) widen();
    if (isWide(index)) {
      wide_[bond] = index;
    } else {
      narrow_[bond] = static_cast<std::uint16_t>(index);
    }
  }

  bool operator==(const ClassIndices&) const = default;

  std::vector<std::uint32_t> inFull() const {
    return wide_.empty() ? std::vector<std::uint32_t>(narrow_.begin(), narrow_.end()) : wide_;
  }
  std::size_t memoryBytes() const {
    return narrow_.capacity() * sizeof(std::uint16_t) + wide_.capacity() * sizeof(std::uint32_t);
  }

 private:
  static bool fits(std::uint32_t index) { return index <= std::numeric_limits<std::uint16_t>::max(); }
  bool isWide(std::uint32_t index) const { return !wide_.empty() || !fits(index); }

  void widen() {
    if (!wide_.empty()) return;
    wide_.reserve(narrow_.capacity());
    wide_.assign(narrow_.begin(), narrow_.end());
    narrow_ = {};
  }

  std::vector<std::uint16_t> narrow_;
  std::vector<std::uint32_t> wide_;  ///< where some index needs it; empty otherwise
};

}  // namespace sim
