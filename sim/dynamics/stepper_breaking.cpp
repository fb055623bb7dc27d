#include <algorithm>
#include <cmath>

#include "sim/base/parallel.h"
#include "sim/dynamics/stepper.h"

namespace sim {
namespace {

/// Below this share of the squared length at which it breaks, no rounding makes a bond break.
constexpr double kSurelyWhole = 1.0 - 1e-5;
constexpr std::size_t kBlocksPerTask = 512;

}  // namespace

double Stepper::strainIn(const Motion& motion, BondIndex bond) const {
  return strainIn(motion, bond, network_.bondStart(bond));
}

double Stepper::strainIn(const Motion& motion, BondIndex bond, NodeIndex a) const {
  const NodeIndex b = network_.bondEnds[bond];
  const double length = (motion.position.get(b) - motion.position.get(a)).norm();
  return length / layout_.restLength(network_, bond) - 1.0;
}

/// The exact test, for the rows of suspect blocks only.
std::vector<Breakage::Overstretched> Stepper::findOverstretched(const Motion& motion) const {
  using Found = std::vector<Breakage::Overstretched>;
  const std::span<const std::uint32_t> blocks = fragments_.activity().activeBlocks();
  return collectInOrder<Breakage::Overstretched>(blocks.size(), kBlocksPerTask,
                                                 [&](std::size_t b, Found& found) {
                                                   if (reports_[blocks[b]].suspect)
                                                     testBlock(motion, blocks[b], found);
                                                 });
}

void Stepper::testBlock(const Motion& motion, std::size_t block,
                        std::vector<Breakage::Overstretched>& found) const {
  const std::size_t end = std::min(network_.nodeCount(), (block + 1) * kBlockNodes);
  for (auto node = static_cast<NodeIndex>(block * kBlockNodes); node < end; ++node) {
    // Nodes of rigid bodies are not where the bodies are until someone looks.
    if (!fragments_.activity().nodeDeforms(node)) continue;
    for (BondIndex bond = network_.firstBond[node]; bond < network_.firstBond[node + 1]; ++bond) {
      if (breakage_.bondBroken(bond)) continue;
      const double limit =
          layout_.restLength(network_, bond) * (1.0 + static_cast<double>(network_.thresholds[bond]));
      const Vec3 apart = motion.position.get(network_.bondEnds[bond]) - motion.position.get(node);
      if (apart.squaredNorm() < kSurelyWhole * limit * limit) continue;
      const auto strain = static_cast<float>(strainIn(motion, bond, node));
      if (strain > network_.thresholds[bond]) found.push_back({bond, strain});
    }
  }
}

/// Takes a broken bond out of the lattice. Its tension energy is dropped, by rule 1 of docs/numerics.md; in
/// compression it keeps its energy and goes on repelling (P4). The bond's last kick carried velocities from
/// half a step before to half a step behind, so what is dropped is the mean of its energies before and after:
/// either alone would leave the account wrong in first order of the step. With one-step methods both are the
/// present one.
void Stepper::loseBond(const BreakEvent& event) {
  const BondClass& bond = network_.bond(event.bond);
  const double restLength = layout_.restLength(network_, event.bond);
  const auto extensionIn = [&](const Motion& motion) {
    return (motion.position.get(event.b) - motion.position.get(event.a)).norm() - restLength;
  };
  const double before = std::max(0.0, extensionIn(breakingMotion()));
  const double after = extensionIn(now_);
  const double stiffness = bond.stiffness * controls_.materials()[bond.material].stiffnessScale;
  if (after > 0.0) ledger_.addReleased(0.25 * stiffness * (before * before + after * after));
  contacts_.addBroken(event.bond, restLength);
  layout_.remove(network_, event.bond);
}

void Stepper::breakOverstretched() {
  const std::vector<Breakage::Overstretched> overstretched = findOverstretched(breakingMotion());
  if (overstretched.empty()) {
    ++work_.labelingsSkipped;
    return;
  }
  const std::size_t before = events_.size();
  const auto strainOf = [&](BondIndex bond) { return static_cast<float>(strainIn(breakingMotion(), bond)); };
  breakage_.breakBonds(overstretched, oneStep_ ? time() : time() - step_, strainOf, events_);
  startKnown_ = false;
  const std::span<const BreakEvent> fresh = std::span<const BreakEvent>(events_).subspan(before);
  for (const BreakEvent& event : fresh) loseBond(event);
  if (components_.relabel(layout_, fresh, time())) {
    fragments_.noteBirths(time());
    if (reference_) reference_->noteBirths(components_);
    contacts_.noteBirths();
  }
  work_.labelings = components_.relabelings();
}

}  // namespace sim
