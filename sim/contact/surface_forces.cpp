#include "sim/contact/surface_forces.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "sim/base/parallel.h"
#include "sim/contact/surface_follow.h"

namespace sim {
namespace {

constexpr std::size_t kGrain = 64;
/// Of the natural gap: nothing may be deeper at the end of a step, however fast it came.
constexpr double kDeepestShare = 3.5;

struct SurfacePush {
  std::array<Vec3, 4> total{};
  std::array<Vec3, 4> lossy{};
  SurfaceGap gap;
  double opening = 0.0;  ///< cm/s
  bool pushes = false;
  bool falls = false;  ///< would be too deep at the end of the step
};

PairConstants constantsNow(const ContactModel& model, const SurfaceContact& contact,
                           const ContactMoment& moment) {
  const PairConstants unscaled{contact.stiffness, contact.damping};
  if (!moment.scaled) return unscaled;
  const NodeIndex other = contact.crossing() ? contact.nodes[2] : contact.nodes[1];
  return model.scaled(unscaled, contact.nodes[0], {0.0, other, kNone}, moment.materials);
}

/// cm: what is that deep at the end of a step is stopped there.
double deepestGap(const SurfaceContact& contact) {
  return contact.rho - kDeepestShare * contact.natural;
}

SurfacePush pushOf(const ContactModel& model, const SurfaceContact& contact, const ContactMoment& moment) {
  SurfacePush push;
  push.gap = gapOf(contact, moment.motion.position);
  const SurfaceGap& gap = push.gap;
  const double depth = contact.rho - gap.gap;
  const Vec3 relative = weightedSum(gap.weights, contact.nodes, moment.motion.velocity);
  const double opening = relative.dot(gap.normal);
  push.opening = opening;
  push.falls = gap.gap + moment.kick * opening < deepestGap(contact);
  if (depth <= 0.0) return push;
  push.pushes = true;
  const PairConstants constants = constantsNow(model, contact, moment);
  const double elastic = constants.stiffness * depth;
  const double normal = std::max(0.0, elastic - constants.damping * opening);
  Vec3 hold = Vec3::Zero();
  Vec3 drag = Vec3::Zero();
  if (contact.anchored != 0) {
    hold = -constants.stiffness * tangentialStretch(contact, gap, moment.motion.position);
    const Vec3 slip = relative - opening * gap.normal;
    drag = -constants.damping * slip;
    // The drag of what slides is within the cone, too.
    const double room = std::max(0.0, model.settings().friction * elastic - hold.norm());
    const double most = drag.norm();
    if (most > room) drag *= room / most;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    push.total[i] = gap.weights[i] * (normal * gap.normal + drag) + contact.anchor[i] * hold;
    push.lossy[i] = gap.weights[i] * ((normal - elastic) * gap.normal + drag);
  }
  return push;
}

/// Takes the speed from what would be too deep at the end of this step, as an inelastic impact does: springs
/// that could hold it would need shorter steps. Nodes share their mass among the contacts that stop them.
void stopFalls(const ContactModel& model, const SurfaceRows& rows, const ContactMoment& moment,
               std::vector<SurfacePush>& pushes) {
  if (!moment.wholeStep || moment.kick <= 0.0 || std::ranges::none_of(pushes, &SurfacePush::falls)) return;
  std::vector<std::uint32_t> stopped(model.network().nodeCount(), 0);
  for (std::size_t c = 0; c < pushes.size(); ++c) {
    if (!pushes[c].falls) continue;
    for (const NodeIndex node : rows.contacts[c].nodes) ++stopped[node];
  }
  for (std::size_t c = 0; c < pushes.size(); ++c) {
    SurfacePush& push = pushes[c];
    if (!push.falls) continue;
    const SurfaceContact& contact = rows.contacts[c];
    double give = 0.0;    // 1/g: of the point of contact, among all that stop its nodes
    double change = 0.0;  // cm/s^2: by the push that there is
    for (std::size_t i = 0; i < 4; ++i) {
      const double mass = model.network().masses[contact.nodes[i]];
      if (!std::isfinite(mass) || !moment.moves(contact.nodes[i])) continue;
      const double weight = push.gap.weights[i];
      give += weight * weight * stopped[contact.nodes[i]] / mass;
      change += weight * push.total[i].dot(push.gap.normal) / mass;
    }
    if (give <= 0.0) continue;
    const double allowed = (deepestGap(contact) - push.gap.gap) / moment.kick;
    const double force = (allowed - push.opening - change * moment.kick) / (give * moment.kick);
    if (force <= 0.0) continue;
    push.pushes = true;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 more = push.gap.weights[i] * force * push.gap.normal;
      push.total[i] += more;
      push.lossy[i] += more;
    }
  }
}

}  // namespace

void addSurfaceForces(const ContactModel& model, const SurfaceRows& rows, const ContactMoment& moment,
                      ContactForces& forces) {
  if (rows.contacts.empty()) return;
  std::vector<SurfacePush> pushes(rows.contacts.size());
  parallelRanges(pushes.size(), kGrain, Sharing::balanced, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) pushes[c] = pushOf(model, rows.contacts[c], moment);
  });
  stopFalls(model, rows, moment, pushes);
  for (std::size_t c = 0; c < pushes.size(); ++c) {
    if (!pushes[c].pushes) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      const NodeIndex node = rows.contacts[c].nodes[i];
      if (!moment.moves(node)) continue;
      forces.touched[node / kBlockNodes] = 1;
      forces.total.add(node, pushes[c].total[i]);
      forces.lossy.add(node, pushes[c].lossy[i]);
    }
  }
}

double surfaceEnergy(const ContactModel& model, const SurfaceRows& rows, const ContactMoment& moment) {
  double sum = 0.0;
  for (const SurfaceContact& contact : rows.contacts) {
    const double scale = constantsNow(model, contact, moment).stiffness / contact.stiffness;
    sum += scale * contactEnergy(contact, moment.motion.position);
  }
  return sum;
}

Stiffest stiffestSurfaces(const ContactModel& model, const SurfaceRows& rows, const ContactMoment& moment) {
  std::unordered_map<NodeIndex, Stiffest> sums;
  for (const SurfaceContact& contact : rows.contacts) {
    const SurfaceGap gap = gapOf(contact, moment.motion.position);
    if (gap.gap - contact.natural > RowAge::kChoiceShare * model.largestNatural()) continue;
    const PairConstants constants = constantsNow(model, contact, moment);
    for (std::size_t i = 0; i < 4; ++i) {
      const NodeIndex node = contact.nodes[i];
      const double mass = model.network().masses[node];
      if (!std::isfinite(mass)) continue;
      const double weight = std::min(1.0, std::abs(gap.weights[i]) + 0.1);
      sums[node].rateSquared += 2.0 * weight * constants.stiffness / mass;
      sums[node].damping += 2.0 * weight * constants.damping / mass;
    }
  }
  Stiffest most;
  for (const auto& [node, sum] : sums) most.raise(sum);
  return most;
}

}  // namespace sim
