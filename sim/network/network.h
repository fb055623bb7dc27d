#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/result.h"
#include "sim/base/types.h"
#include "sim/network/class_indices.h"

namespace sim {

inline constexpr double kUnbreakable = std::numeric_limits<double>::infinity();

/// What the simulation needs to know of a material beyond each bond's own stiffness and damping.
struct Material {
  std::string name;
  double thresholdMean = kUnbreakable;  ///< t_ij of the paper: breaks when stretched past (1 + t) rest length
  double thresholdSpread = 0.0;         ///< standard deviation of t relative to its mean
  double yieldStrain = kUnbreakable;    ///< |strain| above which the rest length flows; infinite: elastic
  double flowRate = 0.0;  ///< 1/s: share of the excess strain by which the rest length flows a second

  bool operator==(const Material&) const = default;
};

/// Bonds of equal constants share one record: in a regular lattice a few dozen classes serve a million bonds,
/// which is what lets the force kernel read one value for a whole run of the lattice.
struct BondClass {
  double stiffness = 0.0;   ///< k, dyn/cm, > 0
  double restLength = 0.0;  ///< l, cm, > 0
  double damping = 0.0;     ///< d, g/s, >= 0
  MaterialIndex material = 0;

  bool operator==(const BondClass&) const = default;
};

/// The eight corners of a cell: corner c = i + 2 j + 4 k at local coordinates (i, j, k), right-handed, so
/// that the signed volume is positive.
using CellCorners = std::array<NodeIndex, 8>;

/// The dynamic solid model N = {nodes, bonds} of the paper (section "Dynamic solid models"), with cells, as
/// it is before anything moves. Built by buildNetwork(), never edited by hand.
///
/// Invariants (validate()): at most one bond a pair; bonds sorted by (first, second) with first < second, so
/// that firstBond is a row index; all constants finite and positive; cells name eight existing nodes, all
/// different but in wedges (sim/network/wedge.h); those of a part stand together, in the order of parts. A
/// node of infinite mass is held: it keeps its velocity whatever pulls at it.
struct Network {
  // Copied and destroyed in network.cpp, which saves each source that passes networks on half a second to
  // compile.
  Network();
  Network(const Network& other);
  Network(Network&& other) noexcept;
  Network& operator=(const Network& other);
  Network& operator=(Network&& other) noexcept;
  ~Network();

  // Nodes, one entry each.
  std::vector<Vec3> positions;   ///< R_i, cm
  std::vector<Vec3> velocities;  ///< V_i, cm/s
  std::vector<double> masses;    ///< m_i, g; infinite for a held node
  std::vector<float>
      radii;  ///< distance to the nearest bonded neighbour at rest, cm (paper, "Collision detection")
  std::vector<MaterialIndex> nodeMaterials;
  std::vector<PartIndex> nodeParts;

  // Bonds, sorted. Bond b joins node a, where firstBond[a] <= b < firstBond[a + 1], with bondEnds[b] > a.
  std::vector<BondIndex> firstBond;  ///< nodeCount() + 1 entries
  std::vector<NodeIndex> bondEnds;
  ClassIndices bondClasses;
  std::vector<float> thresholds;  ///< t_ij, already varied at random; infinite: unbreakable

  std::vector<BondClass> classes;
  std::vector<CellCorners> cells;
  std::vector<Material> materials;
  std::vector<std::string> partNames;

  std::size_t nodeCount() const { return positions.size(); }
  std::size_t bondCount() const { return bondEnds.size(); }
  std::size_t cellCount() const { return cells.size(); }

  /// First node of a bond, by bisection of firstBond.
  NodeIndex bondStart(BondIndex bond) const;
  /// The bond between two different nodes, or kNone. O(log of the row).
  BondIndex findBond(NodeIndex a, NodeIndex b) const;
  const BondClass& bond(BondIndex b) const { return classes[bondClasses[b]]; }

  /// The first broken invariant in words, or nothing.
  std::optional<std::string> validate() const;

  /// Bytes held by all arrays.
  std::size_t memoryBytes() const;
};

/// One bond as a modeller states it. Nodes in either order.
struct BlueprintBond {
  NodeIndex a = 0;
  NodeIndex b = 0;
  double stiffness = 0.0;   ///< dyn/cm
  double restLength = 0.0;  ///< cm
  double damping = 0.0;     ///< g/s
  MaterialIndex material = 0;
};

/// Unsorted input of buildNetwork(). Node order is kept: give nodes in lattice order, the longest axis
/// innermost (consecutive), because neighbours at equal index distance are what the force kernel reads in one
/// go.
struct Blueprint {
  struct Node {
    Vec3 position = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
    double mass = 0.0;
    MaterialIndex material = 0;
    PartIndex part = 0;
  };
  std::vector<Node> nodes;
  std::vector<BlueprintBond> bonds;
  std::vector<CellCorners> cells;
  std::vector<Material> materials;
  std::vector<std::string> partNames;
};

/// Sorts, interns classes (constants equal to 1e-12 relative share one), draws thresholds
/// (sim/network/thresholds.h) and checks. A Problem names the first offending node, bond or cell: two bonds
/// on one pair, an index out of range, a non-positive or non-finite constant.
Result<Network> buildNetwork(Blueprint blueprint, std::uint64_t seed);

}  // namespace sim
