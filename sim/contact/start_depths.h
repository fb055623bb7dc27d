#pragma once

#include <array>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "sim/base/bytes.h"
#include "sim/collider/moving_collider.h"
#include "sim/contact/contact_rows.h"
#include "sim/fracture/components.h"
#include "sim/state/motion.h"

namespace sim {

/// Which nodes began inside colliders, and how they are let out: a collider's surface begins where the node
/// is, and goes from there to where it is meant to be, slowly. So what begins inside something is not thrown
/// out of it (docs/numerics.md, Contact 12).
class StartDepths {
 public:
  /// cm/s: how fast what began inside is pushed out.
  static constexpr double kSpeed = 3.0;

  /// How far inside its collider a surface is, cm, and how fast it goes outwards, cm/s.
  struct Surface {
    double depth = 0.0;
    double speed = 0.0;
  };

  bool empty() const { return depths_.empty(); }
  /// Where the surface of a collider is for a node that it would push along `normal` at a time (s).
  Surface of(NodeIndex node, std::uint32_t collider, const Vec3& normal, double time) const;

  /// The collider is as if it were not there for the node, which began inside and is let be until it is out.
  bool letsBe(NodeIndex node, std::uint32_t collider, const Vec3& normal, double time) const {
    return !depths_.empty() &&
           of(node, collider, normal, time).depth == std::numeric_limits<double>::infinity();
  }

  /// Where everything is when something begins.
  struct Scene {
    const ContactModel& model;
    const Components& components;
    const NodeVectors& positions;
    std::span<const MovingCollider> colliders;
    double time = 0.0;  ///< s
  };
  /// All free nodes that an active collider would throw out faster than kSpeed begin inside it; where they
  /// were inside among `before`, too, by how much deeper they are. `near`: all that may be inside, by node,
  /// then collider. Colliders are in one order in both; there may be more now.
  ///
  /// A fragment is pushed one way out of a collider, and only by nodes whose nearest way that is. It is let
  /// be where its nodes would have to go different ways, where it would get deeper into something on the way,
  /// and where some of it is held.
  void begin(const Scene& scene, std::span<const NodeAtCollider> near,
             std::span<const MovingCollider> before);
  /// Forgets nodes that are out by now, and how deep others were that are less deep. Once a step.
  void follow(const NodeVectors& positions, std::span<const MovingCollider> colliders, double time);

  void save(ByteWriter& writer) const;
  bool load(ByteReader& reader, std::size_t nodeCount, std::size_t colliderCount);
  std::size_t memoryBytes() const { return depths_.capacity() * sizeof(Depth); }

 private:
  struct Depth {
    double depth = 0.0;           ///< cm, at `since`
    double since = 0.0;           ///< s
    std::array<double, 3> way{};  ///< unit, out of the collider; zero: it is let be
    NodeIndex node = kNone;
    std::uint32_t collider = 0;

    Vec3 wayOut() const { return {way[0], way[1], way[2]}; }
  };
  static std::pair<NodeIndex, std::uint32_t> placeOf(const Depth& depth);
  static bool isPushed(const Depth& depth, const Vec3& normal);
  static double depthAt(const Depth& depth, double time);

  std::vector<Depth> depths_;  ///< by node, then collider
};

}  // namespace sim
