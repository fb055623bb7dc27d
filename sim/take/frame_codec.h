#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/base/bytes.h"
#include "sim/base/result.h"
#include "sim/network/network.h"
#include "sim/state/snapshot.h"

namespace sim {

// Contents of the chunks that record motion. A snapshot is stored in two parts: its breakage, which in most
// frames is what it was (Broken), and the frame, which is all that moves.

/// What the arrays of a snapshot must agree with.
struct NetworkSize {
  std::size_t nodes = 0;
  std::size_t bonds = 0;
  std::size_t cells = 0;
  static NetworkSize of(const Network& network) {
    return {network.nodeCount(), network.bondCount(), network.cellCount()};
  }
};

ByteWriter encodeBreakage(const Broken& broken);
ByteWriter encodeFrame(const Snapshot& snapshot);

/// How nodes stand and move in a whole frame, which later ones may lean on.
struct WholeFrame {
  std::vector<Vec3> positions;
  std::vector<Vec3> velocities;
};
/// One flag a node: position or velocity is other than there, by any bit.
std::vector<std::uint8_t> changedNodes(const Snapshot& snapshot, const WholeFrame& whole);
/// The frame with the changed nodes alone. `whole`: the sequence of the chunk it leans on.
ByteWriter encodeChange(const Snapshot& snapshot, std::uint64_t whole,
                        const std::vector<std::uint8_t>& changed);
/// What a change begins with; nothing where it is too short.
std::optional<std::uint64_t> wholeFrameOf(std::span<const std::byte> change);
/// The arrays that come back have the network's sizes.
Result<BrokenPointer> decodeBreakage(const NetworkSize& size, std::span<const std::byte> breakage);

/// What comes back has arrays of the network's sizes and passes faultOf().
Result<Snapshot> decodeSnapshot(const NetworkSize& size, std::span<const std::byte> frame,
                                const BrokenPointer& broken);
/// The same of a change and the whole frame it leans on.
Result<Snapshot> decodeSnapshot(const NetworkSize& size, std::span<const std::byte> change,
                                std::span<const std::byte> whole, const BrokenPointer& broken);

ByteWriter encodeEvents(const std::vector<BreakEvent>& events);
/// Every index that comes back is in the network.
Result<std::vector<BreakEvent>> decodeEvents(const NetworkSize& size, std::span<const std::byte> content);

/// The first thing by which a snapshot doesn't fit the network, in words: arrays of other lengths, more
/// fragments than nodes, fragments not strictly in order of their ids, a node in a fragment that is not there
/// (kNone is allowed), a time that is not finite. Asked before writing and after reading.
std::optional<std::string> faultOf(const NetworkSize& size, const Snapshot& snapshot);
/// The first event that names what is not in the network, or more events than bonds, in words.
std::optional<std::string> faultOf(const NetworkSize& size, const std::vector<BreakEvent>& events);

}  // namespace sim
