#pragma once

#include <limits>
#include <optional>

#include "sim/contact/contact_rows.h"
#include "sim/contact/contact_search.h"
#include "sim/contact/row_age.h"
#include "sim/contact/start_depths.h"
#include "sim/contact/surface_rows.h"

namespace sim {

/// What pushes on nodes from outside the lattice: surfaces or nodes of other fragments, broken bonds in
/// compression, colliders.
///
/// Contact of two nodes (docs/numerics.md, "Contact and friction"): force max(0, k (rho - x) - d v_n) along
/// the line between them, rho at most the natural length. A pair that becomes eligible closer than that
/// starts with rho its present distance, and rho grows only while the two are apart, so that switching a
/// contact on never adds energy. A pair whose bond broke repels by that bond's own k and l; contact takes
/// over at a rebuild that finds it in different fragments and apart. Friction opposes sliding by friction * k
/// * intrusion, and never reverses it within a step.
///
/// This knows who may touch whom. The forces are functions over it (contact_forces.h).
class Contacts {
 public:
  Contacts(const Network& network, const ContactSettings& settings);

  const ContactModel& model() const { return model_; }
  const ContactRows& rows() const { return rows_; }
  ColliderHolds& holds() { return rows_.holds; }
  const SurfaceRows& surfaces() const { return surfaces_; }
  const Outside& outside() const { return outside_; }
  const StartDepths& starts() const { return starts_; }
  /// Pairs of nodes, and of nodes or edges with surfaces, that are looked at.
  std::size_t pairCount() const { return rows_.pairCount() + surfaces_.near.size(); }
  /// Nothing can push.
  bool quiet() const { return rows_.quiet() && surfaces_.quiet(); }
  /// How long the rows cover all that can touch.
  RowAge& age() { return age_; }
  const RowAge& age() const { return age_; }

  /// A bond broke at this rest length (cm): it goes on repelling.
  void addBroken(BondIndex bond, double restLength);
  /// Ages the rows by one step in which no node moved further than `travel` (cm).
  void ageByStep(const Motion& motion, double travel);
  /// Makes the rows anew at a time (s). `travel`: no node goes further in a step, as far as is known, cm.
  /// What is inside something when this is first done begins there.
  void rebuild(const Motion& motion, const Components& components, const Breakage& breakage,
               std::span<const MovingCollider> colliders, double time, double travel = 0.0);
  /// Lets rho grow where pairs are apart, and forgets what is out of what it began in. Once a step; forces of
  /// the same moment do not depend on it.
  void settle(const Motion& motion, std::span<const MovingCollider> colliders, double time) {
    rows_.growApart(model_, motion);
    if (!starts_.empty()) starts_.follow(motion.position, colliders, time);
  }
  /// What the next rows find deeper inside colliders than it was among these begins there.
  void beginAmong(std::span<const MovingCollider> before) {
    startsAmong_.emplace(before.begin(), before.end());
    age_.makeStale();
  }
  /// Surfaces that touch are found at these positions. Once a step, before its forces. Gives what energy is
  /// lost by it, erg.
  double follow(const NodeVectors& positions);
  /// Remembers the pairs that contacts of the same network remember, under other settings or among other
  /// colliders than `before`. Rows are stale.
  void takeOver(const Contacts& other, std::span<const MovingCollider> before);

  /// Calls visit(i, j) for each two nodes that may push each other before the next rebuild, whichever comes
  /// first; where surfaces are near, for each two of their corners, some several times.
  template <class Visit>
  void forEachNearPair(Visit&& visit) const {
    for (const ContactRow& row : rows_.rows) {
      for (std::uint32_t e = row.firstEntry; e < row.lastEntry; ++e) {
        if (row.node < rows_.entries[e].other) visit(row.node, rows_.entries[e].other);
      }
    }
    for (const BrokenPair& pair : rows_.fresh) visit(pair.a, pair.b);
    for (const SurfaceRow& row : surfaces_.rows) {
      for (std::uint32_t n = row.first; n < row.last; ++n) {
        if (row.isEdge) {
          for (const NodeIndex a : outside_.edges()[row.which].nodes) {
            for (const NodeIndex b : outside_.edges()[surfaces_.near[n]].nodes) visit(a, b);
          }
        } else {
          for (const NodeIndex b : outside_.triangles()[surfaces_.near[n]].nodes) visit(row.which, b);
        }
      }
    }
  }
  /// Calls visit(node, collider) for each node that may be pushed by a collider before the next rebuild.
  template <class Visit>
  void forEachNearCollider(Visit&& visit) const {
    for (const ContactRow& row : rows_.rows) {
      for (std::uint32_t c = row.firstCollider; c < row.lastCollider; ++c)
        visit(row.node, rows_.nearColliders[c]);
    }
  }

  std::uint64_t rebuilds() const { return rebuilds_; }
  /// Rebuilds in which nodes were compared with each other.
  std::uint64_t searches() const { return searches_; }

  void save(ByteWriter& writer) const;
  /// False where the bytes cannot have come from save() of such a network.
  bool load(ByteReader& reader, std::span<const MovingCollider> colliders);
  std::size_t memoryBytes() const;

 private:
  ContactModel model_;
  ContactRows rows_;
  RowAge age_;
  HashGrid grid_;
  Outside outside_;
  SurfaceRows surfaces_;
  StartDepths starts_;
  /// Until rows are made for the first time: the colliders among which all was before.
  std::optional<std::vector<MovingCollider>> startsAmong_ = std::vector<MovingCollider>();
  double lastTravel_ =
      std::numeric_limits<double>::infinity();  ///< cm: no node went further in the last step
  bool surfacesStart_ = true;  ///< what is inside another surface at the next look begins there
  std::uint64_t rebuilds_ = 0;
  std::uint64_t searches_ = 0;
};

}  // namespace sim
