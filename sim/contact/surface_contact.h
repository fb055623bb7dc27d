#pragma once

#include <array>

#include "sim/base/types.h"
#include "sim/state/motion.h"

namespace sim {

/// Two places of surfaces that may push each other: a node and the nearest point of a triangle, of its edge
/// or corner; or the crossing of two edges. It knows from which side they met.
struct SurfaceContact {
  /// The node, then the triangle's corners; or the ends of one edge, then of the other.
  std::array<NodeIndex, 4> nodes{};
  std::uint32_t row = 0;      ///< of SurfaceRows
  std::uint8_t corners = 0;   ///< as in ClosestOnTriangle; kCrossing for two edges
  std::uint8_t anchored = 0;  ///< friction holds: `anchor` counts
  std::uint8_t inside = 0;    ///< the node is behind what it meets
  double sign = 1.0;       ///< -1: of an edge or corner that is met from within; of crossings, of the normal
  double natural = 0.0;    ///< cm: the gap below which they push, at most
  double rho = 0.0;        ///< cm: at present. They begin with the gap they have
  double stiffness = 0.0;  ///< dyn/cm, unscaled
  double damping = 0.0;    ///< g/s, unscaled
  std::array<double, 4> anchor{};  ///< weights of the two points that friction holds together

  static constexpr std::uint8_t kCrossing = 8;
  bool isInside() const { return inside != 0; }
  bool crossing() const { return corners == kCrossing; }
};

/// Where a contact stands.
struct SurfaceGap {
  std::array<double, 4> weights{};  ///< of the nodes: their weighted sum leads from one point to the other
  Vec3 normal = Vec3::Zero();       ///< unit: moving the node, or the first edge, along it opens the gap
  double gap = 0.0;                 ///< cm, negative inside
};
SurfaceGap gapOf(const SurfaceContact& contact, const NodeVectors& positions);

Vec3 weightedSum(const std::array<double, 4>& weights, const std::array<NodeIndex, 4>& nodes,
                 const NodeVectors& vectors);
/// From where friction holds to where the contact is, in the plane of contact, cm.
Vec3 tangentialStretch(const SurfaceContact& contact, const SurfaceGap& gap, const NodeVectors& positions);
/// Moves the anchor so that the stretch is this, cm.
void anchorAt(SurfaceContact& contact, const SurfaceGap& gap, const Vec3& stretch,
              const NodeVectors& positions);

}  // namespace sim
