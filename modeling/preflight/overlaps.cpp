#include "modeling/preflight/overlaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>

#include "modeling/preflight/escape.h"
#include "modeling/preflight/obstacle_depths.h"
#include "modeling/preflight/part_solid.h"
#include "sim/control/driven.h"

namespace modeling {
namespace {

// Of the smaller mean edge of the two parts' cells.
constexpr double kRounding = 0.02;
/// What stands between the nodes of a part and is no deeper does so because cells are coarse.
constexpr double kBetweenNodes = 0.25;
/// Gluing bends cells near the seam, also against what else is glued there.
constexpr double kBentByGlue = 1.0;

class Finder {
 public:
  Finder(const BuiltScene& built, const std::function<bool()>& keepGoing)
      : built_(built), network_(built.network), keepGoing_(keepGoing) {
    std::vector<std::size_t> cellCounts;
    for (const PartReport& part : built.parts) cellCounts.push_back(part.cells);
    parts_ = partsOf(network_, cellCounts);
    findBodies();
  }

  std::vector<Overlap> run() {
    const auto& colliders = built_.conditions.environment.colliders;
    for (std::uint32_t c = 0; c < colliders.size() && goesOn(); ++c) {
      const sim::MovingCollider now = sim::colliderAt(colliders[c], c, built_.conditions.tracks, 0.0).at;
      if (now.active) lookInto(now.shape);
    }
    for (const auto& [a, b] : pairsThatMeet()) {
      if (!goesOn()) break;
      lookAt(a, b);
    }
    if (!goesOn()) found_.clear();
    return std::move(found_);
  }

 private:
  using Pair = std::array<std::size_t, 2>;

  bool goesOn() const { return !keepGoing_ || keepGoing_(); }

  void findBodies() {
    std::map<std::string, std::size_t> index;
    for (std::size_t p = 0; p < parts_.size(); ++p) index.emplace(built_.parts[p].name, p);
    bodyOf_.resize(parts_.size());
    std::iota(bodyOf_.begin(), bodyOf_.end(), std::size_t{0});
    for (const GlueReport& glue : built_.glue) {
      const std::size_t a = index.at(glue.a), b = index.at(glue.b);
      glued_.push_back({std::min(a, b), std::max(a, b)});
      const std::size_t from = bodyOf_[a], to = bodyOf_[b];
      std::ranges::replace(bodyOf_, from, to);
    }
    std::ranges::sort(glued_);
    for (const PartCells& part : parts_) {
      const auto isHeld = [&](sim::NodeIndex node) { return !std::isfinite(network_.masses[node]); };
      held_.push_back(std::ranges::all_of(part.nodes, isHeld) ? 1 : 0);
    }
  }

  bool hasOthersGlued(std::size_t part) const { return std::ranges::count(bodyOf_, bodyOf_[part]) > 1; }

  PartSolid& solid(std::size_t part) {
    const auto [entry, isNew] = solids_.try_emplace(part, nullptr);
    if (isNew) entry->second = std::make_unique<PartSolid>(network_, parts_[part]);
    return *entry->second;
  }

  // Obstacles.

  void lookInto(const sim::Collider& obstacle) {
    const std::vector<NodeInside> deepest = deepestNodes(network_, obstacle);
    std::map<std::size_t, std::optional<Vec3>> escapes;  // by body
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      const NodeInside& inside = deepest[p];
      if (inside.depth == 0.0) {
        lookBetweenNodes(obstacle, p);
        continue;
      }
      const auto [escape, isNew] = escapes.try_emplace(bodyOf_[p]);
      if (isNew) escape->second = escapeOf(bodyOf_[p], obstacle, deepest);
      Overlap& overlap = found_.emplace_back();
      overlap.kind = Overlap::Kind::partInObstacle;
      overlap.part = built_.parts[p].name;
      overlap.other = obstacle.name;
      overlap.depth = inside.depth;
      overlap.at = network_.positions[inside.node];
      if (escape->second) overlap.mend = {overlap.part, *escape->second, hasOthersGlued(p)};
    }
  }

  std::optional<Vec3> escapeOf(std::size_t body, const sim::Collider& obstacle,
                               const std::vector<NodeInside>& deepest) {
    NodeLook look;
    look.any = true;
    NodeInside worst;
    Eigen::AlignedBox3d box;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      const bool belongs = bodyOf_[p] == body;
      look.only.push_back(belongs ? 1 : 0);
      if (!belongs) continue;
      box.extend(parts_[p].box);
      if (deepest[p].depth > worst.depth) worst = deepest[p];
    }
    const auto isFree = [&](const Vec3& move) {
      look.move = move;
      const auto isOutside = [](const NodeInside& node) { return node.depth == 0.0; };
      return goesOn() && std::ranges::all_of(deepestNodes(network_, obstacle, look), isOutside);
    };
    Eigen::AlignedBox3d still = sim::boxOf(obstacle);
    const auto* const surface = std::get_if<sim::SurfaceShape>(&obstacle.shape);
    if (surface != nullptr && !still.isEmpty()) {
      const Vec3 out = Vec3::Constant(surface->halfThickness);
      still = {still.min() - out, still.max() + out};
    }
    return shortEscape(worst.depth, worst.wayOut, box, still, isFree);
  }

  void lookBetweenNodes(const sim::Collider& obstacle, std::size_t p) {
    if (held_[p] != 0 || parts_[p].cells.empty() || !sim::boxOf(obstacle).intersects(parts_[p].box)) return;
    PartSolid& part = solid(p);
    part.prepare();
    const PartSolid::Inside inside = deepestPoint(obstacle, part, kBetweenNodes * part.edge());
    if (inside.depth == 0.0) return;
    Overlap& overlap = found_.emplace_back();
    overlap.kind = Overlap::Kind::obstacleInPart;
    overlap.part = built_.parts[p].name;
    overlap.other = obstacle.name;
    overlap.depth = inside.depth;
    overlap.at = inside.at;
    const auto isFree = [&](const Vec3& move) {
      sim::Collider moved = obstacle;
      moved.position -= move;
      return goesOn() && deepestPoint(moved, part, kBetweenNodes * part.edge()).depth == 0.0;
    };
    if (const auto move = shortEscape(inside.depth, -inside.wayOut, part.box(), sim::boxOf(obstacle), isFree))
      overlap.mend = {overlap.part, *move, hasOthersGlued(p)};
  }

  // Pairs of parts.

  /// Those whose boxes overlap, but for those that are glued to each other or both held.
  std::vector<Pair> pairsThatMeet() const {
    std::vector<std::size_t> order(parts_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::erase_if(order, [&](std::size_t p) { return parts_[p].box.isEmpty(); });
    std::ranges::stable_sort(order, {}, [&](std::size_t p) { return parts_[p].box.min().x(); });
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Eigen::AlignedBox3d& box = parts_[order[i]].box;
      for (std::size_t j = i + 1; j < order.size() && parts_[order[j]].box.min().x() < box.max().x(); ++j) {
        const Pair pair{std::min(order[i], order[j]), std::max(order[i], order[j])};
        if (!box.intersects(parts_[order[j]].box) || (held_[pair[0]] != 0 && held_[pair[1]] != 0)) continue;
        if (!std::ranges::binary_search(glued_, pair)) pairs.push_back(pair);
      }
    }
    std::ranges::sort(pairs);
    return pairs;
  }

  void lookAt(std::size_t first, std::size_t second) {
    PartSolid &a = solid(first), &b = solid(second);
    const double edge = std::min(a.edge(), b.edge());
    const double tolerance =
        bodyOf_[first] == bodyOf_[second] ? kBentByGlue * std::max(a.edge(), b.edge()) : kRounding * edge;
    PartSolid::Inside deepest = a.deepestOf(b, {Vec3::Zero(), tolerance, false});
    const PartSolid::Inside other = b.deepestOf(a, {Vec3::Zero(), tolerance, false});
    if (other.depth > deepest.depth) deepest = {other.depth, other.at, -other.wayOut};
    if (deepest.depth == 0.0) return;
    Overlap& overlap = found_.emplace_back();
    overlap.kind = Overlap::Kind::parts;
    overlap.part = built_.parts[first].name;
    overlap.other = built_.parts[second].name;
    overlap.depth = deepest.depth;
    overlap.at = deepest.at;
    const auto isFree = [&](const Vec3& move) {
      return goesOn() && a.deepestOf(b, {move, tolerance, true}).depth == 0.0 &&
             b.deepestOf(a, {-move, tolerance, true}).depth == 0.0;
    };
    const auto move = shortEscape(deepest.depth, deepest.wayOut, b.box(), a.box(), isFree);
    if (!move) return;
    overlap.depth = move->norm();
    const bool firstMoves = held_[second] != 0 || (held_[first] == 0 && move->z() < 0.0);
    const std::size_t moved = firstMoves ? first : second;
    overlap.mend = {built_.parts[moved].name, firstMoves ? Vec3(-*move) : *move, hasOthersGlued(moved)};
  }

  const BuiltScene& built_;
  const sim::Network& network_;
  const std::function<bool()>& keepGoing_;
  std::vector<PartCells> parts_;
  std::vector<std::size_t> bodyOf_;  ///< by part: the same for those that glue joins
  std::vector<std::uint8_t> held_;   ///< by part: nonzero, none of its nodes can move
  std::vector<Pair> glued_;          ///< ascending: those that are glued to each other
  std::map<std::size_t, std::unique_ptr<PartSolid>> solids_;
  std::vector<Overlap> found_;
};

}  // namespace

std::vector<Overlap> findOverlaps(const BuiltScene& built, const std::function<bool()>& keepGoing) {
  return Finder(built, keepGoing).run();
}

}  // namespace modeling
