#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <queue>
#include <tuple>

#include "modeling/glue/glue.h"
#include "modeling/glue/nearest.h"
#include "modeling/shapes/quality.h"

namespace modeling {
namespace {

using sim::kNone;

/// A cell whose longest edge would be this many times its shortest, and twice what it was, is not worth
/// having: short edges make short steps.
constexpr double kLong = 6.0;

/// How much farther than the nearest partner another may be. With a wide reach, taking any in reach scatters
/// the inner layers of a part, and two thirds of the pairs have to be let go again as twisted (measured on a
/// teapot's handle).
constexpr double kAlternative = 1.5;

std::string inCentimetres(double length) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g cm", length);
  return text;
}

std::optional<sim::Problem> checkPart(const GluePart& part) {
  if (part.nodes.empty())
    return sim::Problem{"", "'" + part.name + "' has no nodes to glue", "give it a shape"};
  for (const Vec3& node : part.nodes)
    if (!node.allFinite())
      return sim::Problem{"", "'" + part.name + "' has a node that is not finite",
                          "mend its shape or placement"};
  return std::nullopt;
}

sim::Result<GluePreview> pairsGiven(const GluePart& a, const GluePart& b, const GlueSettings& settings) {
  GluePreview preview;
  preview.pairs = settings.explicitPairs;
  std::sort(preview.pairs.begin(), preview.pairs.end(),
            [](const GluePair& p, const GluePair& q) { return std::tie(p.a, p.b) < std::tie(q.a, q.b); });
  for (std::size_t i = 0; i < preview.pairs.size(); ++i) {
    GluePair& pair = preview.pairs[i];
    if (pair.a >= a.nodes.size() || pair.b >= b.nodes.size())
      return sim::Problem{"", "a pair names a node that does not exist",
                          "name nodes below " + std::to_string(a.nodes.size()) + " of '" + a.name +
                              "' and below " + std::to_string(b.nodes.size()) + " of '" + b.name + "'"};
    if (i > 0 && pair.a == preview.pairs[i - 1].a)
      return sim::Problem{"", "node " + std::to_string(pair.a) + " of '" + a.name + "' is in two pairs",
                          "give it one partner"};
    pair.distance = (a.nodes[pair.a] - b.nodes[pair.b]).norm();
    preview.worstDistance = std::max(preview.worstDistance, pair.distance);
  }
  return preview;
}

/// Pairs the nodes in reach: each with the nearest while there is one free for each, nearest pairs first.
class Pairing {
 public:
  Pairing(const GluePart& a, const GluePart& b, const GlueSettings& settings)
      : a_(a), b_(b), settings_(settings), index_(b.nodes), partner_(a.nodes.size()) {}

  sim::Result<GluePreview> run() {
    if (auto problem = choose()) return *problem;
    pairUp();
    for (const sim::CellCorners& cell : a_.cells)
      if (std::any_of(cell.begin(), cell.end(),
                      [&](NodeIndex node) { return partner_[node].point != kNone; }))
        touched_.push_back(cell);
    flattenTwisted();
    releaseTwisted();
    GluePreview preview;
    preview.nodesReleased = released_;
    for (NodeIndex node = 0; node < a_.nodes.size(); ++node) {
      if (partner_[node].point == kNone) continue;
      preview.pairs.push_back({node, partner_[node].point, partner_[node].distance});
      preview.worstDistance = std::max(preview.worstDistance, partner_[node].distance);
    }
    return preview;
  }

 private:
  using Found = NearestPoints::Found;
  struct Candidate {
    double distance;
    NodeIndex a, b;
    bool operator>(const Candidate& other) const {
      return std::tie(distance, a, b) > std::tie(other.distance, other.a, other.b);
    }
  };

  std::optional<sim::Problem> choose() {
    std::vector<bool> excluded(a_.nodes.size(), false);
    for (const NodeIndex node : settings_.excludedNodes) {
      if (node >= excluded.size())
        return sim::Problem{"", "an excluded node does not exist in '" + a_.name + "'",
                            "name nodes below " + std::to_string(excluded.size())};
      excluded[node] = true;
    }
    double closest = std::numeric_limits<double>::infinity();
    partner_.assign(a_.nodes.size(), {kNone, 0.0});
    nearest_ = partner_;
    bool any = false;
    for (NodeIndex node = 0; node < a_.nodes.size(); ++node) {
      if (excluded[node]) continue;
      if (const auto found = index_.nearest(a_.nodes[node], settings_.reach)) {
        nearest_[node] = *found;
        any = true;
      } else if (!any) {
        const auto beyond = index_.nearest(a_.nodes[node], closest);
        if (beyond) closest = beyond->distance;
      }
    }
    if (any) return std::nullopt;
    const std::string what =
        "no node of '" + a_.name + "' is within " + inCentimetres(settings_.reach) + " of '" + b_.name + "'";
    if (!std::isfinite(closest)) return sim::Problem{"", what, "leave it nodes that may be glued"};
    return sim::Problem{"", what + ", the nearest is " + inCentimetres(closest) + " away",
                        "move the parts together or raise the reach"};
  }

  void pairUp() {
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue;
    for (NodeIndex node = 0; node < a_.nodes.size(); ++node)
      if (nearest_[node].point != kNone) queue.push({nearest_[node].distance, node, nearest_[node].point});
    while (!queue.empty()) {
      const Candidate best = queue.top();
      queue.pop();
      if (!index_.taken(best.b)) {
        index_.take(best.b);
        partner_[best.a] = {best.b, best.distance};
      } else if (const auto other = index_.nearestFree(a_.nodes[best.a], alternativeReach(best.a))) {
        queue.push({other->distance, best.a, other->point});
      } else {
        partner_[best.a] = nearest_[best.a];
      }
    }
  }

  double alternativeReach(NodeIndex node) const {
    return std::min(settings_.reach, kAlternative * nearest_[node].distance);
  }

  /// Where a cell would be twisted by corners that had to make way, they go back to their nearest, where it
  /// becomes flat and drops out.
  void flattenTwisted() {
    for (bool changed = true; changed;) {
      changed = false;
      for (const sim::CellCorners& cell : touched_) {
        if (!isTwisted(cell)) continue;
        for (const NodeIndex corner : cell) {
          if (partner_[corner].point == nearest_[corner].point) continue;
          partner_[corner] = nearest_[corner];
          changed = true;
        }
      }
    }
  }
  /// Where a cell is twisted even so, its farthest corner is let go, until none is.
  void releaseTwisted() {
    for (bool changed = true; changed;) {
      changed = false;
      for (const sim::CellCorners& cell : touched_) {
        if (!isTwisted(cell)) continue;
        NodeIndex farthest = kNone;
        for (const NodeIndex corner : cell) {
          if (partner_[corner].point == kNone) continue;
          if (farthest == kNone || partner_[corner].distance > partner_[farthest].distance) farthest = corner;
        }
        partner_[farthest] = {kNone, 0.0};
        ++released_;
        changed = true;
      }
    }
  }
  bool isTwisted(const sim::CellCorners& cell) const {
    CornerPositions corners;
    int moved = 0;
    bool isWedge = false;
    for (std::size_t c = 0; c < 8; ++c) {
      const NodeIndex partner = partner_[cell[c]].point;
      moved += partner != kNone;
      corners[c] = partner != kNone ? b_.nodes[partner] : a_.nodes[cell[c]];
      for (std::size_t before = 0; before < c; ++before) isWedge = isWedge || corners[before] == corners[c];
    }
    if (moved == 0 || moved == 8) return false;
    if (isWedge) return scaledJacobianOfWedge(corners) < kBentIn;
    const double aspect = cellAspect(corners);
    return scaledJacobian(corners) < kBentIn ||
           (aspect > kLong && aspect > 2.0 * cellAspect(cornerPositions(a_.nodes, cell)));
  }

  const GluePart& a_;
  const GluePart& b_;
  const GlueSettings& settings_;
  NearestPoints index_;
  std::vector<Found> nearest_, partner_;
  std::vector<sim::CellCorners> touched_;  ///< cells with a corner that is glued
  std::size_t released_ = 0;
};

}  // namespace

sim::Result<GluePreview> previewGlue(const GluePart& a, const GluePart& b, const GlueSettings& settings) {
  if (&a == &b || settings.a == settings.b)
    return sim::Problem{"", "'" + a.name + "' would be glued to itself", "name two different parts"};
  if (auto problem = checkPart(a)) return *problem;
  if (auto problem = checkPart(b)) return *problem;
  if (!settings.explicitPairs.empty()) return pairsGiven(a, b, settings);
  if (!(settings.reach > 0.0) || !std::isfinite(settings.reach))
    return sim::Problem{"reach", "the reach must be a positive number of centimetres",
                        "use about half the cell size"};
  return Pairing(a, b, settings).run();
}

}  // namespace modeling
