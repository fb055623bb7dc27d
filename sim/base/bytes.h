#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/base/types.h"

namespace sim {

// Files and checkpoints are little-endian; so is every machine this is built for, hence no swapping anywhere.
static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Vec3) == 3 * sizeof(double), "Vec3 is stored as its three doubles");

/// What may be stored as its bytes. Vec3 has user-provided copies in Eigen 3.4 but is three doubles and no
/// more. bool is left out: a damaged byte other than 0 and 1 would be undefined behaviour (store
/// std::uint8_t). Types with padding would make equal states unequal in bytes: store their members.
template <class T>
concept Storable = !std::is_same_v<T, bool> && !std::is_pointer_v<T> &&
                   (std::is_trivially_copyable_v<T> || std::is_same_v<T, Vec3>);

/// Appends values to a growing block of bytes.
class ByteWriter {
 public:
  template <Storable T>
  void put(const T& value) {
    append(&value, sizeof(T));
  }

  /// The count (64 bits), then the values.
  template <Storable T>
  void putVector(const std::vector<T>& values) {
    put<std::uint64_t>(values.size());
    append(values.data(), values.size() * sizeof(T));
  }

  /// The length (64 bits), then the characters.
  void putString(std::string_view text) {
    put<std::uint64_t>(text.size());
    append(text.data(), text.size());
  }

  /// Bytes as they are, without a count.
  void putBytes(std::span<const std::byte> bytes) { append(bytes.data(), bytes.size()); }

  /// Room for `size` more bytes, to be filled by the caller before anything else is put.
  std::span<std::byte> extend(std::size_t size);

  std::size_t size() const { return bytes_.size(); }
  std::span<const std::byte> bytes() const { return bytes_; }
  std::vector<std::byte> take() && { return std::move(bytes_); }

 private:
  void append(const void* data, std::size_t size) {
    const std::span<std::byte> room = extend(size);
    if (size > 0) std::memcpy(room.data(), data, size);
  }

  std::vector<std::byte> bytes_;
};

/// Reads what a ByteWriter wrote, from bytes that may be damaged: nothing is read past the end, and no count
/// is believed before the bytes it promises are seen to be there. The first failure sticks: every later read
/// fails too and leaves zero or nothing behind, so a whole record may be read before ok() is asked once.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <Storable T>
  bool read(T& value) {
    const std::span<const std::byte> bytes = readBytes(sizeof(T));
    if (!ok_) {
      value = zero<T>();
      return false;
    }
    std::memcpy(static_cast<void*>(&value), bytes.data(), sizeof(T));
    return true;
  }

  template <Storable T>
  bool readVector(std::vector<T>& values) {
    values.clear();
    std::uint64_t count = 0;
    if (!read(count) || count > rest_.size() / sizeof(T)) return fail();
    const std::span<const std::byte> bytes = readBytes(static_cast<std::size_t>(count) * sizeof(T));
    values.resize(static_cast<std::size_t>(count));
    if (count > 0) std::memcpy(static_cast<void*>(values.data()), bytes.data(), bytes.size());
    return true;
  }

  bool readString(std::string& text) {
    std::vector<char> characters;
    const bool read = readVector(characters);
    text.assign(characters.begin(), characters.end());
    return read;
  }

  /// The next `size` bytes where they stand, or nothing.
  std::span<const std::byte> readBytes(std::size_t size) {
    if (!ok_ || size > rest_.size()) {
      fail();
      return {};
    }
    const std::span<const std::byte> bytes = rest_.first(size);
    rest_ = rest_.subspan(size);
    return bytes;
  }

  /// For those who read by this reader and find that what they read cannot be. Always false.
  bool fail() {
    ok_ = false;
    rest_ = {};
    return false;
  }

  bool ok() const { return ok_; }
  std::size_t remaining() const { return rest_.size(); }
  /// All went well and nothing is left over: what a record asks when it is through.
  bool finished() const { return ok_ && rest_.empty(); }

 private:
  template <class T>
  static T zero() {
    if constexpr (std::is_same_v<T, Vec3>) {
      return Vec3::Zero();
    } else {
      return T{};
    }
  }

  std::span<const std::byte> rest_;
  bool ok_ = true;
};

}  // namespace sim
