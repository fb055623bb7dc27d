#pragma once

#include <cstdint>

#include "sim/base/bytes.h"
#include "sim/contact/contact_model.h"
#include "sim/state/motion.h"

namespace sim {

/// How long contact rows still cover all that can touch: by how far nodes and colliders have moved since the
/// rows were filled.
class RowAge {
 public:
  /// What is near what, as found when rows are filled.
  struct Found {
    bool pairsMayMeet =
        false;  ///< there are fragments, broken bonds or self contact to keep rows of pairs for
    bool hasColliders = false;       ///< some collider acts
    bool collidersEnd = false;       ///< some collider has another side to come out on
    double colliderClearance = 0.0;  ///< cm: no node outside the rows is nearer to a collider
  };

  /// Rows have just been filled for these positions.
  void begin(const Found& found, const NodeVectors& positions);
  /// The rows must be filled anew before they are used again.
  bool stale() const { return stale_; }
  void makeStale() { stale_ = true; }
  /// Fragments were born, and new pairs may touch. A burst of breaks shares one rebuild a few steps later.
  void noteBirths();
  /// No collider moved further than this since the rows were last asked whether they are stale, cm.
  void moveColliders(double travel);
  /// Ages the rows by one step in which no node moved further than `travel` (cm). No length in the rows is
  /// longer than `longest` (cm).
  void age(const ContactModel& model, const Motion& motion, double longest, double travel);
  /// The next age() by such a travel (cm) may look at all positions.
  bool looksAfter(double travel) const {
    return stepsToRebuild_ > 0 || stale_ || slack_ - travel <= nextTravel(travel);
  }

  /// cm that nodes and colliders have travelled at most since the rows were filled
  double odometer() const { return odometer_; }
  /// Nodes may come out of some collider on another side.
  bool collidersEnd() const { return found_.collidersEnd; }
  /// The step was chosen by what stiffest() says of this moment. That holds until so much has moved that
  /// pairs not counted in it may touch.
  void noteChoice() { odometerAtChoice_ = odometer_; }
  bool choiceIsOld(const ContactModel& model) const;
  /// How far a node may go in a step, cm: further, and it could leap over what it should have touched.
  double longestTravel(const ContactModel& model) const;
  /// The same, where something may touch.
  static double travelLimit(const ContactModel& model);

  void save(ByteWriter& writer) const;
  /// `collidersEnd` as in Found. False where the bytes cannot have come from save() of so many nodes.
  bool load(ByteReader& reader, std::size_t nodeCount, bool collidersEnd);
  std::size_t memoryBytes() const { return reference_.size() > 0 ? reference_.memoryBytes() : 0; }

  /// Pairs further apart than this share of the largest natural length beyond their own do not count in the
  /// stable step, which is chosen again before they can have met.
  static constexpr double kChoiceShare = 0.1;

 private:
  /// cm: where colliders have another side, rows are filled again before the next step may lead through one
  /// that is in none.
  double nextTravel(double travel) const { return found_.collidersEnd ? travel : 0.0; }
  bool anyMayTouch() const { return found_.pairsMayMeet || found_.hasColliders; }

  Found found_;
  NodeVectors reference_;  ///< positions when the rows were filled
  bool stale_ = true;
  double odometer_ = 0.0;
  double odometerAtChoice_ = 0.0;
  double slack_ = 0.0;           ///< cm that may yet be travelled before the displacements must be looked at
  double colliderTravel_ = 0.0;  ///< cm: of the odometer, what colliders went
  std::uint32_t stepsToRebuild_ = 0;  ///< counts down after births; 0: no rebuild is due
};

}  // namespace sim
