#include "sim/contact/row_age.h"

#include <algorithm>
#include <array>
#include <limits>

#include "sim/contact/shared_motion.h"

namespace sim {
namespace {

/// A burst of breaks is given this many steps before the rows are filled anew. Pairs of new fragments are at
/// least about a bond's length apart, and move far less than the skin in so few steps.
constexpr std::uint32_t kStepsAfterBirth = 8;
/// Of the collider skin: a quarter of the largest radius is well within any cell.
constexpr double kTravelShare = 0.25;

}  // namespace

void RowAge::begin(const Found& found, const NodeVectors& positions) {
  found_ = found;
  if (anyMayTouch()) reference_ = positions;
  colliderTravel_ = 0.0;
  odometer_ = 0.0;
  odometerAtChoice_ = 0.0;
  slack_ = 0.0;
  stepsToRebuild_ = 0;
  stale_ = false;
}

void RowAge::noteBirths() {
  if (stepsToRebuild_ == 0) stepsToRebuild_ = kStepsAfterBirth;
}

void RowAge::moveColliders(double travel) {
  odometer_ += travel;
  if (stale_ || !found_.hasColliders) return;
  colliderTravel_ += travel;
  slack_ -= travel;
  if (slack_ < 0.0) stale_ = true;
}

void RowAge::age(const ContactModel& model, const Motion& motion, double longest, double travel) {
  odometer_ += travel;
  if (stepsToRebuild_ > 0 && --stepsToRebuild_ == 0) stale_ = true;
  if (stale_ || !anyMayTouch()) return;
  slack_ -= travel;
  if (slack_ > nextTravel(travel)) return;

  // The bound ran out: look how far nodes really are from where they would be, had all gone on together.
  const SharedMotion moved(reference_, motion.position);
  const double unlimited = std::numeric_limits<double>::max();
  const double pairRoom =
      found_.pairsMayMeet ? moved.nearest(longest + model.pairSkin()) - longest : unlimited;
  const double colliderRoom =
      found_.hasColliders ? found_.colliderClearance - moved.furthest() - colliderTravel_ : unlimited;
  // Two nodes close in on each other by both their ways.
  slack_ = std::min(0.5 * pairRoom, colliderRoom);
  if (slack_ <= nextTravel(travel)) stale_ = true;
}

bool RowAge::choiceIsOld(const ContactModel& model) const {
  return anyMayTouch() && 2.0 * (odometer_ - odometerAtChoice_) > kChoiceShare * model.largestNatural();
}

double RowAge::longestTravel(const ContactModel& model) const {
  return anyMayTouch() ? travelLimit(model) : std::numeric_limits<double>::infinity();
}

double RowAge::travelLimit(const ContactModel& model) {
  const double skin = model.colliderSkin();
  return skin > 0.0 ? kTravelShare * skin : std::numeric_limits<double>::infinity();
}

void RowAge::save(ByteWriter& writer) const {
  for (std::size_t k = 0; k < 3; ++k)
    writer.putVector(std::vector<double>(reference_.axis(k), reference_.axis(k) + reference_.size()));
  for (const bool flag : {found_.pairsMayMeet, found_.hasColliders, stale_})
    writer.put<std::uint8_t>(flag ? 1 : 0);
  writer.put(odometer_);
  writer.put(odometerAtChoice_);
  writer.put(slack_);
  writer.put(colliderTravel_);
  writer.put(found_.colliderClearance);
  writer.put(stepsToRebuild_);
}

bool RowAge::load(ByteReader& reader, std::size_t nodeCount, bool collidersEnd) {
  std::array<std::vector<double>, 3> reference;
  for (std::vector<double>& axis : reference) reader.readVector(axis);
  std::array<std::uint8_t, 3> flags{};
  for (std::uint8_t& flag : flags) reader.read(flag);
  reader.read(odometer_);
  reader.read(odometerAtChoice_);
  reader.read(slack_);
  reader.read(colliderTravel_);
  reader.read(found_.colliderClearance);
  reader.read(stepsToRebuild_);
  found_.pairsMayMeet = flags[0] != 0;
  found_.hasColliders = flags[1] != 0;
  found_.collidersEnd = collidersEnd;
  stale_ = flags[2] != 0;
  const std::size_t length = reference[0].size();
  const bool proper = reader.ok() && (length == nodeCount || (length == 0 && !anyMayTouch())) &&
                      reference[1].size() == length && reference[2].size() == length;
  if (!proper) return false;
  reference_ = NodeVectors(length);
  for (std::size_t k = 0; k < 3; ++k) std::copy(reference[k].begin(), reference[k].end(), reference_.axis(k));
  return true;
}

}  // namespace sim
