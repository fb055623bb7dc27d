#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "modeling/exchange/lammps_model.h"

namespace modeling {

namespace {

/// Levels of thresholds are so far apart, by their ratio.
constexpr double kLevelRatio = 1.04;
/// Rounding of the scene's numbers, which makes no other length.
constexpr double kSameLength = 1e-9;
/// The shortest bond, in LAMMPS' units: its nodes would have to come within a fiftieth of it before the push
/// of quartic bonds, below 1.12, is felt.
constexpr double kShortestBond = 56.0;

double thresholdOf(const sim::Network& network, sim::BondIndex bond) {
  return static_cast<double>(network.thresholds[bond]);
}

/// Bonds whose constants agree to nine digits: below that is what sums of cells were rounded by. The last
/// number is the level of the threshold.
using BondKind = std::array<std::int64_t, 4>;

BondKind kindOf(const sim::BondClass& bond, double threshold) {
  static constexpr std::int64_t kNoNumber = std::numeric_limits<std::int64_t>::min();
  const auto rounded = [](double constant) {
    return constant > 0.0 ? std::llround(1e9 * std::log(constant)) : kNoNumber;
  };
  const std::int64_t level = std::isfinite(threshold) && threshold > 0.0
                                 ? std::llround(std::log(threshold) / std::log(kLevelRatio))
                                 : kNoNumber;
  return {rounded(bond.stiffness), rounded(bond.restLength), rounded(bond.damping), level};
}

bool sameSpring(const BondKind& left, const BondKind& right) {
  return std::equal(left.begin(), left.begin() + 3, right.begin());
}

void addSprings(LammpsModel& model) {
  const sim::Network& network = *model.network;
  std::map<BondKind, std::vector<sim::BondIndex>> kinds;
  for (sim::BondIndex bond = 0; bond < network.bondCount(); ++bond)
    kinds[kindOf(network.bond(bond), thresholdOf(network, bond))].push_back(bond);
  model.typeOfBond.resize(network.bondCount());
  const BondKind* before = nullptr;
  sim::BondIndex first = 0;
  for (const auto& [kind, bonds] : kinds) {
    const bool isNew = before == nullptr || !sameSpring(*before, kind);
    if (isNew) first = bonds.front();
    before = &kind;
    double mean = 0.0;
    for (const sim::BondIndex bond : bonds)
      mean += thresholdOf(network, bond) / static_cast<double>(bonds.size());
    for (const sim::BondIndex bond : bonds) {
      model.typeOfBond[bond] = static_cast<std::uint32_t>(model.bondTypes.size());
      if (std::isfinite(mean))
        model.rounding.largestOfLevels =
            std::max(model.rounding.largestOfLevels, std::abs(mean / thresholdOf(network, bond) - 1.0));
    }
    const sim::BondClass& of = network.bond(first);
    const std::uint32_t number =
        model.bondTypes.empty() ? 0 : model.bondTypes.back().kind + (isNew ? 1U : 0U);
    model.bondTypes.push_back({of.stiffness, of.restLength, of.damping, mean, number});
  }
}

/// The lengths at which a bond may break.
struct BreakRange {
  double least = 0.0, most = 0.0;  ///< cm
  sim::BondIndex bond = 0;
};

/// For each bond that may break, by the end of its range, for a relative change of its threshold.
std::vector<BreakRange> breakRanges(const sim::Network& network, double tolerance) {
  std::vector<BreakRange> ranges;
  for (sim::BondIndex bond = 0; bond < network.bondCount(); ++bond) {
    const double threshold = thresholdOf(network, bond);
    if (!std::isfinite(threshold)) continue;
    const double length = network.bond(bond).restLength;
    const double change = std::max(tolerance * threshold, kSameLength);
    ranges.push_back({length * (1.0 + threshold - change), length * (1.0 + threshold + change), bond});
  }
  std::sort(ranges.begin(), ranges.end(), [](const BreakRange& left, const BreakRange& right) {
    return left.most != right.most ? left.most < right.most : left.bond < right.bond;
  });
  return ranges;
}

/// The fewest lengths of which each range has one; false where there are more than kMostBreakLengths.
bool coverRanges(const std::vector<BreakRange>& ranges, LammpsModel& model) {
  model.breakLengths.clear();
  model.breakOfBond.assign(model.network->bondCount(), sim::kNone);
  for (std::size_t first = 0; first < ranges.size();) {
    if (model.breakLengths.size() == LammpsModel::kMostBreakLengths) return false;
    const double most = ranges[first].most;
    double least = ranges[first].least;
    std::size_t next = first;
    for (; next < ranges.size() && ranges[next].least <= most; ++next) {
      least = std::max(least, ranges[next].least);
      model.breakOfBond[ranges[next].bond] = static_cast<std::uint32_t>(model.breakLengths.size());
    }
    model.breakLengths.push_back(0.5 * (least + most));
    first = next;
  }
  return true;
}

void addBreakLengths(LammpsModel& model) {
  for (double tolerance = 0.0; !coverRanges(breakRanges(*model.network, tolerance), model);)
    tolerance = std::max(1e-4, 2.0 * tolerance);
  if (!model.breaks()) return;
  double shortest = std::numeric_limits<double>::infinity();
  for (const LammpsBondType& type : model.bondTypes) shortest = std::min(shortest, type.restLength);
  model.unitsPerCm = std::exp2(std::ceil(std::log2(kShortestBond / shortest)));
}

/// Sums of numbers, for their standard deviation relative to their mean.
struct Spread {
  double count = 0.0, sum = 0.0, squares = 0.0;

  void add(double number) {
    count += 1.0;
    sum += number;
    squares += number * number;
  }
  double relative() const {
    return count > 0.0 ? std::sqrt(std::max(0.0, squares * count / (sum * sum) - 1.0)) : 0.0;
  }
};

void measureRounding(LammpsModel& model) {
  Spread ours, theirs;
  for (sim::BondIndex bond = 0; bond < model.network->bondCount(); ++bond) {
    if (model.breakOfBond[bond] == sim::kNone) continue;
    const double threshold = thresholdOf(*model.network, bond);
    const sim::BondClass& of = model.network->bond(bond);
    const double mean = model.network->materials[of.material].thresholdMean;
    const double there = model.breakLengths[model.breakOfBond[bond]] / of.restLength - 1.0;
    ours.add(threshold / mean);
    theirs.add(there / mean);
    model.rounding.largest = std::max(model.rounding.largest, std::abs(there / threshold - 1.0));
  }
  model.rounding.spread = ours.relative();
  model.rounding.spreadThere = theirs.relative();
}

}  // namespace

void addBondTypes(LammpsModel& model) {
  addSprings(model);
  addBreakLengths(model);
  measureRounding(model);
}

}  // namespace modeling
