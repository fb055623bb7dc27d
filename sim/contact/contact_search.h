#pragma once

#include <span>
#include <vector>

#include "sim/collider/moving_collider.h"
#include "sim/contact/contact_rows.h"
#include "sim/contact/fragment_boxes.h"
#include "sim/contact/hash_grid.h"
#include "sim/contact/outside.h"
#include "sim/fracture/breakage.h"

namespace sim {

/// Where everything is when it is searched for what may touch.
struct ContactScene {
  const Motion& motion;
  const Components& components;
  const Breakage& breakage;
  std::span<const MovingCollider> colliders;
  const FragmentBoxes& boxes;  ///< of the components, at these positions
  const Outside& outside;
};

/// Some pair may be a contact at all: there are several fragments, or self contact counts.
bool pairsAreCompared(const ContactModel& model, const Components& components);

/// The nodes that are near a box of another fragment, ascending; with self contact, all.
std::vector<NodeIndex> nodesToCompare(const ContactModel& model, const ContactScene& scene);

/// The contacts among these nodes that are nearer than the skin. Those that `rows` remember keep their rho.
/// The grid is scratch.
std::vector<ContactCandidate> findContacts(const ContactModel& model, const ContactRows& rows,
                                           const ContactScene& scene, std::span<const NodeIndex> nodes,
                                           HashGrid& grid);

struct NearColliders {
  std::vector<NodeAtCollider> nodes;  ///< by node, then collider
  double clearance = 0.0;             ///< cm: no other node is nearer to a collider
};
/// The nodes within the skin of an acting collider. No node goes further than `travel` (cm) in a step, as far
/// as is known.
NearColliders findNearColliders(const ContactModel& model, const ContactScene& scene, double travel);

/// Nodes can come out of some collider on another side.
bool anyColliderEnds(std::span<const MovingCollider> colliders);

}  // namespace sim
