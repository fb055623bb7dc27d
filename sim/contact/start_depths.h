#pragma once

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
  /// Where the surface of a collider is for a node at a time (s).
  Surface of(NodeIndex node, std::uint32_t collider, double time) const;

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
  /// then collider. Colliders are in one order in both; there may be more now. Of a fragment whose nodes
  /// would have to go different ways, such as one that stands across a narrow wall, only those are pushed
  /// that go the way most go; the others are let be until they are out.
  void begin(const Scene& scene, std::span<const NodeAtCollider> near,
             std::span<const MovingCollider> before);
  /// Forgets nodes that are out by now, and how deep others were that are less deep.
  void forgetPast(const NodeVectors& positions, std::span<const MovingCollider> colliders, double time);

  void save(ByteWriter& writer) const;
  bool load(ByteReader& reader, std::size_t nodeCount, std::size_t colliderCount);
  std::size_t memoryBytes() const { return depths_.capacity() * sizeof(Depth); }

 private:
  struct Depth {
    double depth = 0.0;  ///< cm, at `since`
    double since = 0.0;  ///< s
    NodeIndex node = kNone;
    std::uint32_t collider = 0;
    std::uint64_t pushes = 0;  ///< else the surface waits for the node
  };
  static std::pair<NodeIndex, std::uint32_t> placeOf(const Depth& depth);
  static Surface surfaceOf(const Depth& depth, double time);

  std::vector<Depth> depths_;  ///< by node, then collider
};

}  // namespace sim
