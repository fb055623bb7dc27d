#pragma once

#include <cstddef>
#include <span>

#include "sim/base/bytes.h"
#include "sim/base/result.h"
#include "sim/network/network.h"
#include "sim/take/take.h"

namespace sim {

// Contents of the two chunks every take begins with. Problems say what is wrong and have no place: the caller
// knows the file.

/// Version of the whole layout; readers refuse a newer one. 2 has changes in place of frames.
inline constexpr std::uint32_t kTakeVersion = 2;

ByteWriter encodeHead(const TakeHeader& header);
Result<TakeHeader> decodeHead(std::span<const std::byte> content);

ByteWriter encodeNetwork(const Network& network);
/// What comes back satisfies Network::validate().
Result<Network> decodeNetwork(std::span<const std::byte> content);

}  // namespace sim
