#include "sim/contact/contact_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/base/parallel.h"

namespace sim {
namespace {

/// What rounding may take off a distance between boxes.
constexpr double kRounding = 1.0 + 1e-9;
/// Nodes of one fragment that were nearer than this, in natural lengths, when at rest are no self contact.
constexpr double kSelfRestShare = 2.0;
constexpr std::size_t kCubesPerTask = 256;
/// Where steps are long, rows cover so many of them around what a node may come out of on another side.
constexpr double kStepsInSkin = 4.0;

bool mayTouch(const ContactModel& model, const ContactRows& rows, const ContactScene& scene, NodeIndex i,
              NodeIndex j) {
  const Network& network = model.network();
  if (scene.components.of(i) == scene.components.of(j)) {
    if (!model.settings().self) return false;
    const double atRest = (network.positions[j] - network.positions[i]).norm();
    if (atRest < kSelfRestShare * model.naturalLength(i, j)) return false;
  } else {
    const bool bySurface = model.settings().kind == ContactKind::surfaces &&
                           !(scene.outside.isLoose(i) && scene.outside.isLoose(j));
    if (!model.settings().between || bySurface) return false;
  }
  const BondIndex bond = network.findBond(i, j);
  return bond == kNone || (scene.breakage.bondBroken(bond) && !rows.isBrokenPair(bond));
}

/// One flag a fragment: some of its nodes may be near the collider. No depth changes by more than the way
/// between two points. Lowers `clearance` to how far the others are at least.
std::vector<std::uint8_t> fragmentsNear(const Collider& collider, double skin, const ContactScene& scene,
                                        double& clearance) {
  std::vector<std::uint8_t> near(scene.components.births().size(), 0);
  for (FragmentId fragment = 0; fragment < near.size(); ++fragment) {
    const FragmentBoxes::Box& box = scene.boxes.of(fragment);
    if (box.isEmpty()) continue;
    const double radius = 0.5 * kRounding * box.diagonal().norm();
    const double apart = -intrusion(collider, box.center()).depth - radius;
    near[fragment] = apart < kRounding * skin ? 1 : 0;
    if (near[fragment] == 0) clearance = std::min(clearance, apart);
  }
  return near;
}

void addNodesNear(std::uint32_t index, double skin, const ContactScene& scene, NearColliders& near) {
  const Collider& collider = scene.colliders[index].shape;
  const std::vector<std::uint8_t> fragments = fragmentsNear(collider, skin, scene, near.clearance);
  if (std::find(fragments.begin(), fragments.end(), 1) == fragments.end()) return;
  const bool plane = collider.isFloor();
  const Vec3 normal = collider.rotation * Vec3::UnitZ();
  const double offset = normal.dot(collider.position);
  for (NodeIndex node = 0; node < scene.components.fragmentOfNode().size(); ++node) {
    if (fragments[scene.components.of(node)] == 0) continue;
    const Vec3 position = scene.motion.position.get(node);
    const double apart = plane ? normal.dot(position) - offset : -intrusion(collider, position).depth;
    if (apart < skin) {
      near.nodes.push_back({node, index});
    } else {
      near.clearance = std::min(near.clearance, apart);
    }
  }
}

}  // namespace

bool pairsAreCompared(const ContactModel& model, const Components& components) {
  const bool several = model.settings().between && components.births().size() > 1;
  // Nodes without bonds have no size.
  return (several || model.settings().self) && model.largestNatural() > 0.0;
}

std::vector<NodeIndex> nodesToCompare(const ContactModel& model, const ContactScene& scene) {
  std::vector<NodeIndex> nodes;
  const bool all = model.settings().self;
  const auto meetings = all ? std::vector<FragmentBoxes::Box>()
                            : scene.boxes.meetings(kRounding * (model.largestNatural() + model.pairSkin()));
  for (NodeIndex node = 0; node < scene.components.fragmentOfNode().size(); ++node) {
    if (all || meetings[scene.components.of(node)].contains(scene.motion.position.get(node)))
      nodes.push_back(node);
  }
  return nodes;
}

std::vector<ContactCandidate> findContacts(const ContactModel& model, const ContactRows& rows,
                                           const ContactScene& scene, std::span<const NodeIndex> nodes,
                                           HashGrid& grid) {
  const NodeVectors& positions = scene.motion.position;
  const bool self = model.settings().self;
  grid.build(positions, nodes, scene.components.fragmentOfNode(), model.largestNatural() + model.pairSkin());
  const auto consider = [&](NodeIndex first, NodeIndex second, std::vector<ContactCandidate>& found) {
    const NodeIndex i = std::min(first, second);
    const NodeIndex j = std::max(first, second);
    const double natural = model.naturalLength(i, j);
    const double reach = natural + model.pairSkin();
    const double squared = (positions.get(j) - positions.get(i)).squaredNorm();
    if (squared >= reach * reach || !mayTouch(model, rows, scene, i, j) || !model.maySpring(i, j)) return;
    const ContactEntry* old = rows.contactOf(i, j);
    const double rho = old != nullptr ? old->rho : std::min(natural, std::sqrt(squared));
    found.push_back({i, j, {rho, kNone, kNone}});
  };
  return collectInOrder<ContactCandidate>(
      grid.cubeCount(), kCubesPerTask, [&](std::size_t cube, std::vector<ContactCandidate>& found) {
        grid.forEachPairOf(cube, self, [&](NodeIndex i, NodeIndex j) { consider(i, j, found); });
      });
}

NearColliders findNearColliders(const ContactModel& model, const ContactScene& scene, double travel) {
  NearColliders near;
  near.clearance = std::numeric_limits<double>::max();
  const double skin =
      std::max(model.colliderSkin(), anyColliderEnds(scene.colliders) ? kStepsInSkin * travel : 0.0);
  for (std::uint32_t c = 0; c < scene.colliders.size(); ++c) {
    if (scene.colliders[c].active) addNodesNear(c, skin, scene, near);
  }
  if (scene.colliders.size() > 1)
    std::ranges::stable_sort(near.nodes, {}, [](const NodeAtCollider& each) { return each.node; });
  return near;
}

bool anyColliderEnds(std::span<const MovingCollider> colliders) {
  return std::ranges::any_of(
      colliders, [](const MovingCollider& collider) { return std::isfinite(deepest(collider.shape)); });
}

}  // namespace sim
