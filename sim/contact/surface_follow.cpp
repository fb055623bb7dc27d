#include "sim/contact/surface_follow.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "sim/base/parallel.h"
#include "sim/contact/closest_point.h"
#include "sim/contact/surface_search.h"

namespace sim {

double contactEnergy(const SurfaceContact& contact, const NodeVectors& positions) {
  const SurfaceGap gap = gapOf(contact, positions);
  const double depth = contact.rho - gap.gap;
  if (depth <= 0.0) return 0.0;
  double energy = 0.5 * contact.stiffness * depth * depth;
  if (contact.anchored != 0)
    energy += 0.5 * contact.stiffness * tangentialStretch(contact, gap, positions).squaredNorm();
  return energy;
}

namespace {

/// Of the largest natural length: deeper than this nothing is followed.
constexpr double kDeepest = 0.5;
/// Of the largest natural length: so much further in is another side's face, where a contact goes from face
/// to face.
constexpr double kLeap = 0.02;
/// What stands on a corner's border by no more than this share counts as within.
constexpr double kCone = 1e-6;
/// Of the largest natural length: rows in which all is further apart are not looked at until it may be
/// nearer.
constexpr double kLookShare = 0.15;
/// The same: what is further apart is no contact yet, however far things went in the last step.
constexpr double kContactShare = 0.6;
/// Of the way in the last step: what two things may come nearer by in this one, and more.
constexpr double kApproach = 4.0;
constexpr std::size_t kRowsPerTask = 32;

/// One row being brought to the present.
class RowFollow {
 public:
  RowFollow(const ContactModel& model, const Outside& outside, const SurfaceMoment& moment,
            std::span<const SurfaceContact> before)
      : model_(model),
        outside_(outside),
        positions_(moment.positions),
        before_(before),
        odometer_(moment.odometer),
        travel_(moment.travel),
        starts_(moment.starts),
        asBefore_(before.size(), 0) {}

  /// `farUntil`: as in SurfaceRows, of the row's triangles.
  void node(std::uint32_t rowIndex, NodeIndex node, std::span<const std::uint32_t> near,
            std::span<double> farUntil, std::vector<SurfaceContact>& found);
  void edge(std::uint32_t rowIndex, std::uint32_t which, std::span<const std::uint32_t> near,
            std::vector<SurfaceContact>& found);
  /// cm: nothing in the row is nearer to touching.
  double clearance() const { return clearance_; }
  /// erg: how much less contacts store now than they did before they were brought to the present, but for
  /// what was let go of by sliding and never was.
  double lost() const;

 private:
  struct Candidate {
    std::uint32_t triangle;
    ClosestOnTriangle closest;
    double distance;  ///< cm
    double natural;   ///< cm: as of the contact it may be
  };
  bool isLocalLeast(const Candidate& candidate, std::span<const Candidate> all) const;
  bool isInside(NodeIndex node, const Candidate& candidate) const;
  void settle(SurfaceContact& contact, const SurfaceContact* old, std::vector<SurfaceContact>& found);
  const SurfaceContact* besideUnclaimed(const SurfaceContact& contact,
                                        std::vector<std::uint8_t>& claimed) const;
  bool goesOn(const SurfaceContact& contact, const SurfaceContact& old) const;

  const ContactModel& model_;
  const Outside& outside_;
  const NodeVectors& positions_;
  std::span<const SurfaceContact> before_;
  double odometer_;
  double travel_;
  bool starts_;
  double clearance_ = std::numeric_limits<double>::infinity();
  double lost_ = 0.0;
  std::vector<std::uint8_t> asBefore_;  ///< by contact of before: it stores what it did
};

bool hasNode(const OutsideTriangle& triangle, NodeIndex node) {
  return std::ranges::find(triangle.nodes, node) != triangle.nodes.end();
}

/// The corners that carry the nearest point, by node.
bool sameFeature(const OutsideTriangle& one, unsigned corners, const OutsideTriangle& two, unsigned others) {
  if (std::popcount(corners) != std::popcount(others)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if ((corners >> i & 1U) == 0) continue;
    bool found = false;
    for (std::size_t j = 0; j < 3; ++j)
      found = found || ((others >> j & 1U) != 0 && two.nodes[j] == one.nodes[i]);
    if (!found) return false;
  }
  return true;
}

/// Nowhere near by is the surface nearer; and of the triangles that share the point this one counts.
bool RowFollow::isLocalLeast(const Candidate& candidate, std::span<const Candidate> all) const {
  const unsigned corners = candidate.closest.corners;
  if (corners == 7U) return true;
  const OutsideTriangle& triangle = outside_.triangles()[candidate.triangle];
  for (const Candidate& other : all) {
    if (other.triangle == candidate.triangle) continue;
    const OutsideTriangle& two = outside_.triangles()[other.triangle];
    bool shares = true;
    for (std::size_t i = 0; i < 3; ++i) {
      if ((corners >> i & 1U) != 0 && !hasNode(two, triangle.nodes[i])) shares = false;
    }
    if (!shares) continue;
    if (!sameFeature(triangle, corners, two, other.closest.corners)) return false;
    if (other.triangle < candidate.triangle) return false;
  }
  return true;
}

bool RowFollow::isInside(NodeIndex node, const Candidate& candidate) const {
  const OutsideTriangle& triangle = outside_.triangles()[candidate.triangle];
  const Vec3 apart = positions_.get(node) - positions_.get(triangle.nodes[0]);
  const unsigned corners = candidate.closest.corners;
  if (corners == 7U) return apart.dot(normalOf(triangle, positions_)) < 0.0;
  Vec3 normal = Vec3::Zero();
  Vec3 point = Vec3::Zero();
  for (std::size_t i = 0; i < 3; ++i)
    point += candidate.closest.weights[static_cast<Eigen::Index>(i)] * positions_.get(triangle.nodes[i]);
  for (std::size_t i = 0; i < 3; ++i) {
    if ((corners >> i & 1U) == 0) continue;
    for (const std::uint32_t t : outside_.trianglesOf(triangle.nodes[i])) {
      const OutsideTriangle& other = outside_.triangles()[t];
      bool shares = true;
      for (std::size_t j = 0; j < 3; ++j) {
        if ((corners >> j & 1U) != 0 && !hasNode(other, triangle.nodes[j])) shares = false;
      }
      if (shares) normal += normalOf(other, positions_);
    }
    break;
  }
  return (positions_.get(node) - point).dot(normal) < 0.0;
}

/// The old contact that shares most corners and goes on nowhere else.
const SurfaceContact* RowFollow::besideUnclaimed(const SurfaceContact& contact,
                                                 std::vector<std::uint8_t>& claimed) const {
  std::size_t best = before_.size();
  std::ptrdiff_t most = 0;
  for (std::size_t b = 0; b < before_.size(); ++b) {
    if (claimed[b] != 0 || before_[b].crossing()) continue;
    const auto shared = std::count_if(contact.nodes.begin() + 1, contact.nodes.end(), [&](NodeIndex node) {
      return std::find(before_[b].nodes.begin() + 1, before_[b].nodes.end(), node) != before_[b].nodes.end();
    });
    if (shared <= most) continue;
    most = shared;
    best = b;
  }
  if (best == before_.size()) return nullptr;
  claimed[best] = 1;
  return &before_[best];
}

/// The way into a surface that the contact would have is the one that the old contact had. Behind a thin
/// wall, or beside an edge, the way to another side of it is a longer one.
bool RowFollow::goesOn(const SurfaceContact& contact, const SurfaceContact& old) const {
  if (contact.nodes == old.nodes) return true;
  return gapOf(contact, positions_).gap > gapOf(old, positions_).gap - kLeap * model_.largestNatural();
}

/// Takes over what the contact remembers, and lets rho and the anchor follow.
void RowFollow::settle(SurfaceContact& contact, const SurfaceContact* old,
                       std::vector<SurfaceContact>& found) {
  const SurfaceGap gap = gapOf(contact, positions_);
  contact.rho = std::min(contact.natural, gap.gap);
  const bool same = old != nullptr && old->nodes == contact.nodes && old->corners == contact.corners &&
                    old->sign == contact.sign;
  bool slides = false;
  // It goes on as deep as it was: on its own place by its rho, on another by its depth.
  if (old != nullptr) {
    const double depth = std::max(0.0, old->rho - gapOf(*old, positions_).gap);
    contact.rho = std::min(contact.natural, same ? old->rho : gap.gap + depth);
  }
  if (gap.gap > contact.rho) contact.rho = std::min(contact.natural, gap.gap);
  clearance_ = std::min(clearance_, gap.gap - contact.natural);
  const double pressed = contact.stiffness * (contact.rho - gap.gap);
  const double friction = model_.settings().friction;
  if (pressed > 0.0 && friction > 0.0) {
    Vec3 stretch = Vec3::Zero();
    if (old != nullptr && old->anchored != 0) {
      const bool sameNodes = old->nodes == contact.nodes;
      if (sameNodes) {
        contact.anchor = old->anchor;
        stretch = tangentialStretch(contact, gap, positions_);
      } else {
        stretch = weightedSum(old->anchor, old->nodes, positions_);
        stretch -= gap.normal.dot(stretch) * gap.normal;
      }
      contact.anchored = 1;
      const double limit = friction * pressed / contact.stiffness;
      const double length = stretch.norm();
      if (length > limit) {
        slides = true;
        // The force on the way was that of the limit, not the mean of both.
        lost_ -= 0.5 * contact.stiffness * (length - limit) * (length - limit);
        stretch *= limit / length;
        anchorAt(contact, gap, stretch, positions_);
      } else if (!sameNodes) {
        anchorAt(contact, gap, stretch, positions_);
      }
    } else {
      anchorAt(contact, gap, stretch, positions_);
    }
  }
  // A new one stores nothing yet, and one that goes on as it was what it stored.
  if (same && !slides) {
    asBefore_[static_cast<std::size_t>(old - before_.data())] = 1;
  } else if (old != nullptr) {
    lost_ -= contactEnergy(contact, positions_);
  }
  found.push_back(contact);
}

double RowFollow::lost() const {
  double lost = lost_;
  for (std::size_t b = 0; b < before_.size(); ++b) {
    if (asBefore_[b] == 0) lost += contactEnergy(before_[b], positions_);
  }
  return lost;
}

void RowFollow::node(std::uint32_t rowIndex, NodeIndex node, std::span<const std::uint32_t> near,
                     std::span<double> farUntil, std::vector<SurfaceContact>& found) {
  const Vec3 point = positions_.get(node);
  const double base = looseReach(model_, outside_, node);
  // What is deep inside looks for its way out among all that is near.
  const bool deep = starts_ || std::ranges::any_of(before_, &SurfaceContact::isInside);
  const double furthest = kContactShare * model_.largestNatural();
  const double far =
      deep ? furthest : std::min(furthest, kLookShare * model_.largestNatural() + kApproach * travel_);
  std::vector<Candidate> all;
  for (std::size_t n = 0; n < near.size(); ++n) {
    // What shares a place with a triangle that is no contact is none either, or is nearer.
    if (!deep && odometer_ < farUntil[n]) {
      clearance_ = std::min(clearance_, far);
      continue;
    }
    const std::uint32_t t = near[n];
    const OutsideTriangle& triangle = outside_.triangles()[t];
    const Vec3 a = positions_.get(triangle.nodes[0]);
    const Vec3 b = positions_.get(triangle.nodes[1]);
    const Vec3 c = positions_.get(triangle.nodes[2]);
    Candidate candidate{t, closestOnTriangle(point, a, b, c), 0.0, 0.0};
    const Vec3& w = candidate.closest.weights;
    candidate.distance = (w[0] * a + w[1] * b + w[2] * c - point).norm();
    candidate.natural = base + reachOf(model_, node, triangle.nodes[0]);
    const double clear = candidate.distance - candidate.natural;
    clearance_ = std::min(clearance_, clear);
    // Both may come.
    farUntil[n] = clear > far ? odometer_ + 0.5 * (clear - far) : 0.0;
    if (clear <= far) all.push_back(candidate);
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (const Candidate& candidate : all) nearest = std::min(nearest, candidate.distance);
  std::vector<SurfaceContact> contacts;
  std::vector<std::uint8_t> beginsInside;
  for (const Candidate& candidate : all) {
    const OutsideTriangle& triangle = outside_.triangles()[candidate.triangle];
    if (!isLocalLeast(candidate, all)) continue;
    const bool inside = isInside(node, candidate);
    if (inside && candidate.distance > kDeepest * model_.largestNatural()) continue;
    SurfaceContact contact;
    contact.nodes = {node, triangle.nodes[0], triangle.nodes[1], triangle.nodes[2]};
    contact.row = rowIndex;
    contact.corners = static_cast<std::uint8_t>(candidate.closest.corners);
    contact.sign = inside && contact.corners != 7U ? -1.0 : 1.0;
    contact.inside = inside ? 1 : 0;
    contact.natural = candidate.natural;
    const PairConstants constants = model_.constantsOf(node, {0.0, triangle.nodes[0], kNone});
    contact.stiffness = constants.stiffness;
    contact.damping = constants.damping;
    contacts.push_back(contact);
    // Behind the nearest of all faces it is really inside, not beyond a thin wall.
    beginsInside.push_back(candidate.distance <= nearest ? 1 : 0);
  }
  // Each old contact goes on in one place: where it was, if there is one there still.
  std::vector<const SurfaceContact*> olds(contacts.size(), nullptr);
  std::vector<std::uint8_t> claimed(before_.size(), 0);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const auto same = std::ranges::find_if(before_, [&](const SurfaceContact& old) {
      return !old.crossing() && old.nodes == contacts[c].nodes;
    });
    if (same == before_.end()) continue;
    olds[c] = &*same;
    claimed[static_cast<std::size_t>(same - before_.begin())] = 1;
  }
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (olds[c] == nullptr) olds[c] = besideUnclaimed(contacts[c], claimed);
    const bool begins = starts_ && beginsInside[c] != 0;
    if (contacts[c].inside != 0 && !begins && (olds[c] == nullptr || !goesOn(contacts[c], *olds[c])))
      continue;
    settle(contacts[c], olds[c], found);
  }
}

void RowFollow::edge(std::uint32_t rowIndex, std::uint32_t which, std::span<const std::uint32_t> near,
                     std::vector<SurfaceContact>& found) {
  const OutsideEdge& one = outside_.edges()[which];
  const Vec3 a0 = positions_.get(one.nodes[0]);
  const Vec3 a1 = positions_.get(one.nodes[1]);
  const double deepest = kDeepest * model_.largestNatural();
  const auto intoFace = [&](std::uint32_t t, const Vec3& from, const Vec3& along, const OutsideEdge& edge) {
    Vec3 into = Vec3::Zero();
    for (const NodeIndex node : outside_.triangles()[t].nodes) {
      if (node != edge.nodes[0] && node != edge.nodes[1]) into = positions_.get(node) - from;
    }
    return Vec3((into - along.dot(into) / along.squaredNorm() * along).normalized());
  };
  for (const std::uint32_t e : near) {
    const OutsideEdge& two = outside_.edges()[e];
    const Vec3 b0 = positions_.get(two.nodes[0]);
    const Vec3 b1 = positions_.get(two.nodes[1]);
    const ClosestOfEdges closest = closestOfEdges(a0, a1, b0, b1);
    const double natural = reachOf(model_, one.nodes[0], two.nodes[0]);
    if (closest.parallel) {
      clearance_ = std::min(clearance_, 0.0);
      continue;
    }
    const Vec3 apart = a0 + closest.s * (a1 - a0) - b0 - closest.t * (b1 - b0);
    const double s = std::clamp(closest.s, 0.0, 1.0);
    const double t = std::clamp(closest.t, 0.0, 1.0);
    clearance_ = std::min(clearance_, (a0 + s * (a1 - a0) - b0 - t * (b1 - b0)).norm() - natural);
    if (s != closest.s || t != closest.t) continue;
    const SurfaceContact* old = nullptr;
    for (const SurfaceContact& each : before_) {
      if (each.crossing() && each.nodes[2] == two.nodes[0] && each.nodes[3] == two.nodes[1]) old = &each;
    }
    const double distance = apart.norm();
    if (distance > deepest + natural) continue;
    SurfaceContact contact;
    contact.nodes = {one.nodes[0], one.nodes[1], two.nodes[0], two.nodes[1]};
    contact.row = rowIndex;
    contact.corners = SurfaceContact::kCrossing;
    contact.natural = natural;
    if (old != nullptr) {
      contact.sign = old->sign;
    } else {
      const Vec3 u = a1 - a0;
      const Vec3 v = b1 - b0;
      const Vec3 towards = apart / (distance > 0.0 ? distance : 1.0);
      // Each must see the other in the wedge before its own edge.
      bool before = distance > 0.0;
      for (const std::uint32_t triangle : two.triangles)
        before = before && towards.dot(intoFace(triangle, b0, v, two)) <= kCone;
      for (const std::uint32_t triangle : one.triangles)
        before = before && -towards.dot(intoFace(triangle, a0, u, one)) <= kCone;
      if (!before) continue;
      contact.sign = u.cross(v).dot(towards) > 0.0 ? 1.0 : -1.0;
    }
    const ContactEntry entry{0.0, two.nodes[0], kNone};
    const PairConstants constants = model_.constantsOf(one.nodes[0], entry);
    contact.stiffness = constants.stiffness;
    contact.damping = constants.damping;
    settle(contact, old, found);
  }
}

}  // namespace

double followSurfaces(const ContactModel& model, const Outside& outside, const SurfaceMoment& moment,
                      SurfaceRows& rows) {
  std::vector<double> lost(rows.rows.size(), 0.0);
  const auto old = [&](std::size_t r) {
    return std::span<const SurfaceContact>(rows.contacts)
        .subspan(rows.firstContact[r], rows.firstContact[r + 1] - rows.firstContact[r]);
  };
  std::vector<SurfaceContact> all = collectInOrder<SurfaceContact>(
      rows.rows.size(), kRowsPerTask, [&](std::size_t r, std::vector<SurfaceContact>& found) {
        if (moment.odometer < rows.clearUntil[r]) return;
        const SurfaceRow& row = rows.rows[r];
        RowFollow follow(model, outside, moment, old(r));
        const std::span near =
            std::span<const std::uint32_t>(rows.near).subspan(row.first, row.last - row.first);
        if (row.isEdge) {
          follow.edge(static_cast<std::uint32_t>(r), row.which, near, found);
        } else {
          follow.node(static_cast<std::uint32_t>(r), row.which, near,
                      std::span(rows.farUntil).subspan(row.first, near.size()), found);
        }
        const double room = 0.5 * (follow.clearance() - kLookShare * model.largestNatural());
        rows.clearUntil[r] = room > 0.0 ? moment.odometer + room : 0.0;
        lost[r] = follow.lost();
      });
  rows.contacts = std::move(all);
  rows.index();
  double sum = 0.0;
  for (const double each : lost) sum += each;
  return sum;
}

}  // namespace sim
