#include "sim/base/bytes.h"

namespace sim {

// Not inline: where GCC 12 sees the vector empty it warns of an overflow that can't be.
std::span<std::byte> ByteWriter::extend(std::size_t size) {
  bytes_.resize(bytes_.size() + size);
  return std::span(bytes_).last(size);
}

}  // namespace sim
