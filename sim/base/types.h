#pragma once

#include <cstdint>

#include <Eigen/Core>

/// The simulation core. Units everywhere: centimetre, gram, second, dyne, erg; z points up.
namespace sim {

using Vec3 = Eigen::Vector3d;

/// Position of a node in the network's node arrays. Nodes keep their lattice order whatever breaks.
using NodeIndex = std::uint32_t;
/// Position of a bond in the network's bond arrays (bonds are sorted by first, then second node).
using BondIndex = std::uint32_t;
using CellIndex = std::uint32_t;
/// A fragment's name for life: given at birth, never used again.
using FragmentId = std::uint32_t;
using MaterialIndex = std::uint16_t;
using PartIndex = std::uint16_t;

inline constexpr std::uint32_t kNone = 0xffffffffU;

}  // namespace sim
