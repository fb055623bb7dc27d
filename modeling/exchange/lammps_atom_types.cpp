#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "modeling/exchange/lammps_model.h"

namespace modeling {

namespace {

/// Nodes of one type differ by so much at most: contacts are as those of the smallest and the softest of it.
constexpr double kLengthRatio = 1.1;
constexpr double kStiffnessRatio = 1.5;

/// What each node's bonds say of it.
void addNodeValues(LammpsModel& model) {
  const sim::Network& network = *model.network;
  model.contactStiffness.assign(network.nodeCount(), std::numeric_limits<double>::infinity());
  model.dampingTime.assign(network.nodeCount(), 0.0);
  std::vector<double> count(network.nodeCount(), 0.0);
  for (sim::NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (sim::BondIndex b = network.firstBond[a]; b < network.firstBond[a + 1]; ++b) {
      const sim::BondClass& bond = network.bond(b);
      model.longestBond = std::max(model.longestBond, bond.restLength);
      for (const sim::NodeIndex node : {a, network.bondEnds[b]}) {
        model.contactStiffness[node] = std::min(model.contactStiffness[node], bond.stiffness);
        model.dampingTime[node] += bond.damping / bond.stiffness;
        count[node] += 1.0;
      }
    }
  }
  for (std::size_t node = 0; node < network.nodeCount(); ++node) {
    if (!std::isfinite(model.contactStiffness[node])) model.contactStiffness[node] = 0.0;
    if (count[node] > 0.0) model.dampingTime[node] /= count[node];
  }
}

/// Points by the cube that they are in.
class Cubes {
 public:
  Cubes(const std::vector<Vec3>& points, double edge) : edge_(edge) {
    for (sim::NodeIndex point = 0; point < points.size(); ++point)
      points_.emplace_back(cubeOf(points[point]), point);
    std::sort(points_.begin(), points_.end());
  }

  /// Calls `see` with each point in the cube of `place` and in those around it.
  template <class See>
  void around(const Vec3& place, const See& see) const {
    const Cube centre = cubeOf(place);
    for (std::int64_t x = centre[0] - 1; x <= centre[0] + 1; ++x) {
      for (std::int64_t y = centre[1] - 1; y <= centre[1] + 1; ++y) {
        auto at = std::lower_bound(points_.begin(), points_.end(),
                                   std::pair(Cube{x, y, centre[2] - 1}, sim::NodeIndex{0}));
        for (; at != points_.end() && at->first <= Cube{x, y, centre[2] + 1}; ++at) see(at->second);
      }
    }
  }

 private:
  using Cube = std::array<std::int64_t, 3>;
  Cube cubeOf(const Vec3& place) const {
    // What flew off further than that is alone.
    const auto number = [&](double along) { return std::llround(std::clamp(along / edge_, -1e15, 1e15)); };
    return {number(place.x()), number(place.y()), number(place.z())};
  }

  double edge_;
  std::vector<std::pair<Cube, sim::NodeIndex>> points_;
};

void addContactLengths(LammpsModel& model) {
  const sim::Network& network = *model.network;
  model.contactLength.assign(network.radii.begin(), network.radii.end());
  const double largest = *std::max_element(model.contactLength.begin(), model.contactLength.end());
  if (!(largest > 0.0)) return;
  const std::vector<Vec3>& positions = model.moment->positions;
  const Cubes cubes(positions, largest);
  for (sim::NodeIndex a = 0; a < network.nodeCount(); ++a) {
    cubes.around(positions[a], [&](sim::NodeIndex b) {
      if (b <= a) return;
      const double apart = (positions[a] - positions[b]).norm();
      const double touching =
          std::min(static_cast<double>(network.radii[a]), static_cast<double>(network.radii[b]));
      if (apart >= touching) return;
      const sim::BondIndex bond = network.findBond(a, b);
      if (bond != sim::kNone && model.bondIsWhole(bond)) return;
      for (const sim::NodeIndex node : {a, b})
        model.contactLength[node] = std::min(model.contactLength[node], apart);
    });
  }
}

std::int64_t levelOf(double number, double ratio) {
  return number > 0.0 ? std::llround(std::floor(std::log(number) / std::log(ratio)))
                      : std::numeric_limits<std::int64_t>::min();
}

}  // namespace

void addAtomTypes(LammpsModel& model) {
  addNodeValues(model);
  addContactLengths(model);
  const sim::Network& network = *model.network;
  std::map<std::tuple<sim::MaterialIndex, bool, std::int64_t, std::int64_t>, std::vector<sim::NodeIndex>>
      kinds;
  for (sim::NodeIndex node = 0; node < network.nodeCount(); ++node)
    kinds[{network.nodeMaterials[node], !std::isfinite(network.masses[node]),
           levelOf(model.contactLength[node], kLengthRatio),
           levelOf(model.contactStiffness[node], kStiffnessRatio)}]
        .push_back(node);
  model.typeOfNode.resize(network.nodeCount());
  for (const auto& [kind, nodes] : kinds) {
    LammpsAtomType type{std::get<0>(kind), std::get<1>(kind), std::numeric_limits<double>::infinity(),
                        std::numeric_limits<double>::infinity()};
    for (const sim::NodeIndex node : nodes) {
      model.typeOfNode[node] = static_cast<std::uint32_t>(model.atomTypes.size());
      type.contactLength = std::min(type.contactLength, model.contactLength[node]);
      type.contactStiffness = std::min(type.contactStiffness, model.contactStiffness[node]);
    }
    model.atomTypes.push_back(type);
  }
}

}  // namespace modeling
