#include "modeling/import/lammps_unwrap.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <vector>

namespace modeling {
namespace {

using sim::Vec3;

constexpr std::array<bool, 3> kAllEdges{true, true, true};
/// Shorter than this share of the way itself, a bond has no length to speak of: its ends are copies of each
/// other.
constexpr double kNoLength = 1e-6;

/// Which bonds go through faces, and by which vector.
class Crossings {
 public:
  Crossings(const LammpsBox& box, const LammpsData& data) : data_(data), through_(data.bonds.size()) {
    const Eigen::Matrix3d edgesFromWorld = box.edges.inverse();
    for (std::size_t bond = 0; bond < data.bonds.size(); ++bond) {
      const Vec3 share = edgesFromWorld * way(bond);
      // Half the box to the last digit is nearer neither way.
      const Vec3 whole = share.unaryExpr(
          [](double along) { return std::abs(along) > 0.5 + 1e-9 ? std::round(along) : 0.0; });
      through_[bond] = box.edges * whole;
    }
    measure();
    for (std::size_t bond = 0; bond < data.bonds.size(); ++bond) {
      if (!likely(bond)) through_[bond] = Vec3::Zero();
    }
  }

  /// What has to be added to the bond's end for the bond to be as short as it can be.
  Vec3 shift(std::size_t bond) const { return -through_[bond]; }
  std::size_t count() const {
    return static_cast<std::size_t>(std::count_if(through_.begin(), through_.end(),
                                                  [](const Vec3& whole) { return whole != Vec3::Zero(); }));
  }

 private:
  Vec3 way(std::size_t bond) const {
    return data_.positions[data_.bonds[bond].b] - data_.positions[data_.bonds[bond].a];
  }

  /// Typical lengths: medians of the bonds that go through no face.
  void measure() {
    std::map<int, std::vector<double>> lengths;
    for (std::size_t bond = 0; bond < data_.bonds.size(); ++bond) {
      if (through_[bond] != Vec3::Zero()) continue;
      lengths[data_.bonds[bond].type].push_back(way(bond).norm());
      lengths[kAnyType].push_back(way(bond).norm());
    }
    for (auto& [type, of] : lengths) {
      const auto middle = of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2);
      std::nth_element(of.begin(), middle, of.end());
      typical_[type] = *middle;
    }
  }

  bool likely(std::size_t bond) const {
    if (through_[bond] == Vec3::Zero()) return false;
    const double direct = way(bond).norm();
    const double around = (way(bond) - through_[bond]).norm();
    if (!(around > kNoLength * direct) || around >= direct) return false;
    auto known = typical_.find(data_.bonds[bond].type);
    if (known == typical_.end()) known = typical_.find(kAnyType);
    if (known == typical_.end() || !(known->second > 0.0)) return around < 0.5 * direct;
    return std::abs(std::log(around / known->second)) < std::abs(std::log(direct / known->second));
  }

  static constexpr int kAnyType = 0;
  const LammpsData& data_;
  std::vector<Vec3> through_;
  std::map<int, double> typical_;  ///< by type of bond
};

/// The bonds of each node, from both ends.
std::vector<std::vector<std::uint32_t>> bondsOfNodes(const LammpsData& data) {
  std::vector<std::vector<std::uint32_t>> bonds(data.positions.size());
  for (std::uint32_t bond = 0; bond < data.bonds.size(); ++bond) {
    bonds[data.bonds[bond].a].push_back(bond);
    bonds[data.bonds[bond].b].push_back(bond);
  }
  return bonds;
}

/// By how much each node is moved: by what hangs together, from its first node on. Bonds through faces are
/// followed when there are no others, so that a ring which does not close is told by one of them.
class Shifts {
 public:
  Shifts(const LammpsData& data, const Crossings& crossings)
      : data_(data),
        crossings_(crossings),
        bonds_(bondsOfNodes(data)),
        shifts_(data.positions.size(), Vec3::Zero()),
        reached_(data.positions.size(), false) {
    for (std::uint32_t root = 0; root < data.positions.size(); ++root) {
      if (reached_[root]) continue;
      reached_[root] = true;
      front_.push_back(root);
      spread();
      while (!through_.empty()) {
        const std::uint32_t bond = through_.back();
        through_.pop_back();
        reach(bond, reached_[data.bonds[bond].a] ? data.bonds[bond].a : data.bonds[bond].b);
        spread();
      }
    }
  }

  const Vec3& operator[](std::uint32_t node) const { return shifts_[node]; }

 private:
  void spread() {
    while (!front_.empty()) {
      const std::uint32_t node = front_.back();
      front_.pop_back();
      for (const std::uint32_t bond : bonds_[node]) {
        if (crossings_.shift(bond) != Vec3::Zero())
          through_.push_back(bond);
        else
          reach(bond, node);
      }
    }
  }
  /// The other end of a node's bond, unless it was reached before.
  void reach(std::uint32_t bond, std::uint32_t node) {
    const std::uint32_t other = otherEnd(bond, node);
    if (reached_[other]) return;
    reached_[other] = true;
    shifts_[other] = shifts_[node] + (data_.bonds[bond].a == node ? 1.0 : -1.0) * crossings_.shift(bond);
    front_.push_back(other);
  }
  std::uint32_t otherEnd(std::uint32_t bond, std::uint32_t node) const {
    return data_.bonds[bond].a == node ? data_.bonds[bond].b : data_.bonds[bond].a;
  }

  const LammpsData& data_;
  const Crossings& crossings_;
  std::vector<std::vector<std::uint32_t>> bonds_;
  std::vector<Vec3> shifts_;
  std::vector<bool> reached_;
  std::vector<std::uint32_t> front_;    ///< nodes whose bonds are to be followed
  std::vector<std::uint32_t> through_;  ///< bonds through faces that are to be followed
};

std::string lengthsOf(double direct, double around) {
  std::ostringstream words;
  words.precision(4);
  words << direct << " apart, or " << around << " through a periodic face of the box";
  return words.str();
}

}  // namespace

sim::Status unwrapBonds(const LammpsBox& box, const std::string& source, LammpsData& data) {
  const Crossings crossings(box, data);
  if (crossings.count() == 0) return sim::Done{};
  const Shifts shifts(data, crossings);
  for (std::size_t bond = 0; bond < data.bonds.size(); ++bond) {
    const LammpsBond& of = data.bonds[bond];
    const Vec3 left = shifts[of.b] - shifts[of.a] - crossings.shift(bond);
    if (left.norm() <= 1e-9 * box.edges.norm()) continue;
    const Vec3 way = data.positions[of.b] - data.positions[of.a];
    return sim::Problem{source + ':' + std::to_string(of.line) + ":1",
                        "bond " + std::to_string(of.id) + " joins atoms " +
                            lengthsOf(way.norm(), (way + crossings.shift(bond)).norm()) +
                            ": it closes a ring through the box, which has no end",
                        "cut the bonds that go through one face of the box"};
  }
  for (std::uint32_t node = 0; node < data.positions.size(); ++node) data.positions[node] += shifts[node];
  data.notes.push_back(std::to_string(crossings.count()) +
                       " bonds went through a periodic face of the box: atoms were moved by whole boxes, so "
                       "that these bonds are short");
  return sim::Done{};
}

}  // namespace modeling
