#include "app/bench/contact_measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "app/bench/bodies.h"
#include "app/bench/timing.h"
#include "sim/contact/closest_point.h"
#include "sim/contact/outside.h"

namespace app {
namespace {

using sim::Vec3;
using Nodes = std::vector<sim::NodeIndex>;

Nodes nodesOf(const sim::Network& network, std::size_t part) {
  Nodes nodes;
  for (sim::NodeIndex node = 0; node < network.nodeCount(); ++node) {
    if (network.nodeParts[node] == part) nodes.push_back(node);
  }
  return nodes;
}

std::size_t lastPart(const sim::Network& network) {
  return network.partNames.size() - 1;
}

Vec3 middleOf(const Nodes& nodes, const std::vector<Vec3>& positions) {
  Vec3 sum = Vec3::Zero();
  for (const sim::NodeIndex node : nodes) sum += positions[node];
  return sum / static_cast<double>(nodes.size());
}

/// cm: the shortest edge of a cell, by which contact takes its measures.
double smallestCell(const sim::Network& network) {
  return static_cast<double>(*std::min_element(network.radii.begin(), network.radii.end()));
}

/// The nodes of a part that are highest (`up` 1) or lowest (-1) before anything moves.
Nodes layerOf(const sim::Network& network, std::size_t part, double up) {
  constexpr double kRounding = 1e-6;  // cm
  const Nodes all = nodesOf(network, part);
  double furthest = -std::numeric_limits<double>::infinity();
  for (const sim::NodeIndex node : all) furthest = std::max(furthest, up * network.positions[node].z());
  Nodes layer;
  for (const sim::NodeIndex node : all) {
    if (up * network.positions[node].z() > furthest - kRounding) layer.push_back(node);
  }
  return layer;
}

/// What of one part is inside another: its nodes and the middles of its edges.
class Meeting {
 public:
  Meeting(const sim::Network& network, std::size_t solid, std::size_t other)
      : nodes_(nodesOf(network, other)) {
    const sim::Outside outside(network);
    for (const sim::OutsideTriangle& triangle : outside.triangles()) {
      if (network.nodeParts[triangle.nodes[0]] == solid) triangles_.push_back(triangle.nodes);
    }
    for (const sim::OutsideEdge& edge : outside.edges()) {
      if (network.nodeParts[edge.nodes[0]] == other) edges_.push_back(edge.nodes);
    }
  }

  /// cm: how deep the deepest of them is, on the shortest way out; `known` where none is deeper than that.
  double deepest(const std::vector<Vec3>& positions, double known) const {
    Eigen::AlignedBox3d box;
    for (const auto& triangle : triangles_) {
      for (const sim::NodeIndex node : triangle) box.extend(positions[node]);
    }
    double deepest = known;
    const auto look = [&](const Vec3& point) {
      if (box.contains(point)) deepest = std::max(deepest, depthOf(point, positions, deepest));
    };
    for (const sim::NodeIndex node : nodes_) look(positions[node]);
    for (const auto& [a, b] : edges_) look(0.5 * (positions[a] + positions[b]));
    return deepest;
  }

 private:
  /// 0 also where it is no deeper than `known`: most points are near a face, so that few are looked at in
  /// full.
  double depthOf(const Vec3& point, const std::vector<Vec3>& positions, double known) const {
    double solidAngle = 0.0, nearest = std::numeric_limits<double>::infinity();
    for (const auto& [i, j, k] : triangles_) {
      const Vec3& a = positions[i];
      const Vec3& b = positions[j];
      const Vec3& c = positions[k];
      const Vec3 weights = sim::closestOnTriangle(point, a, b, c).weights;
      nearest = std::min(nearest, (weights[0] * a + weights[1] * b + weights[2] * c - point).norm());
      if (nearest <= known) return 0.0;
      solidAngle += solidAngleOf(a - point, b - point, c - point);
    }
    // It is 4 pi inside and 0 outside.
    return std::abs(solidAngle) > 2.0 * std::numbers::pi ? nearest : 0.0;
  }
  /// After A. van Oosterom and J. Strackee, "The solid angle of a plane triangle" (1983).
  static double solidAngleOf(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    return 2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }

  std::vector<std::array<sim::NodeIndex, 3>> triangles_;
  Nodes nodes_;
  std::vector<std::array<sim::NodeIndex, 2>> edges_;
};

/// Since when everything that can move has slept.
class SleepWatch {
 public:
  explicit SleepWatch(const sim::Network& network) {
    for (sim::NodeIndex node = 0; node < network.nodeCount(); ++node) {
      if (std::isfinite(network.masses[node])) movable_.push_back(node);
    }
  }
  void look(const sim::Snapshot& now) {
    if (!sleeps(now)) {
      since_.reset();
    } else if (!since_) {
      since_ = now.time;
    }
  }
  std::optional<double> since() const { return since_; }

 private:
  bool sleeps(const sim::Snapshot& now) const {
    std::vector<sim::FragmentId> awake;
    for (const sim::MovingFragment& fragment : now.fragments) {
      if (fragment.state != sim::FragmentState::asleep) awake.push_back(fragment.id);
    }
    std::sort(awake.begin(), awake.end());
    return std::none_of(movable_.begin(), movable_.end(), [&](sim::NodeIndex node) {
      return std::binary_search(awake.begin(), awake.end(), now.broken->fragmentOfNode[node]);
    });
  }

  Nodes movable_;
  std::optional<double> since_;
};

constexpr double kSleepLooks = 50.0;  // a second

}  // namespace

sim::Status TimedRun::to(double time) {
  const double before = secondsNow().cpu;
  const sim::Status ran = simulation_->advanceTo(time);
  cpuSeconds_ += secondsNow().cpu - before;
  return ran;
}

sim::Status TimedRun::toBreak(double time) {
  const double before = secondsNow().cpu;
  sim::Status ran = sim::Done{};
  while (ran && simulation_->brokenBondCount() == 0 && simulation_->time() < time)
    ran = simulation_->stepOnce();
  cpuSeconds_ += secondsNow().cpu - before;
  return ran;
}

sim::Status TimedRun::looking(int looks, double until,
                              const std::function<void(const sim::Snapshot& now)>& look) {
  const double from = simulation_->time();
  for (int i = 1; i <= looks; ++i) {
    if (const sim::Status ran = to(from + (until - from) * i / looks); !ran) return ran;
    look(simulation_->snapshot());
  }
  return sim::Done{};
}

sim::Result<ContactOutcome> measured(modeling::Scene scene, sim::ContactKind kind,
                                     const ContactMeasure& measure) {
  scene.solver.contact.kind = kind;
  auto simulation = start(scene, 1);
  if (!simulation) return simulation.problem();
  TimedRun run(std::move(*simulation));
  auto values = measure(run);
  if (!values) return values.problem();
  return ContactOutcome{std::move(*values), run.cpuSeconds(), run.simulation().maxRise()};
}

ContactMeasure gapAt(double until) {
  return [until](TimedRun& run) -> sim::Result<ContactValues> {
    const Nodes top = layerOf(run.network(), 0, 1.0), bottom = layerOf(run.network(), 1, -1.0);
    if (const sim::Status ran = run.to(until); !ran) return ran.problem();
    const auto positions = run.simulation().snapshot().positions;
    const double gap = middleOf(bottom, positions).z() - middleOf(top, positions).z();
    return ContactValues{gap / smallestCell(run.network())};
  };
}

ContactMeasure slideUntil(double until) {
  return [until](TimedRun& run) -> sim::Result<ContactValues> {
    const Nodes nodes = nodesOf(run.network(), lastPart(run.network()));
    if (const sim::Status ran = run.to(until); !ran) return ran.problem();
    return ContactValues{
        (middleOf(nodes, run.simulation().snapshot().positions) - middleOf(nodes, run.network().positions))
            .x()};
  };
}

ContactMeasure lateSlideUntil(double until) {
  return [until](TimedRun& run) -> sim::Result<ContactValues> {
    const Nodes nodes = nodesOf(run.network(), lastPart(run.network()));
    SleepWatch watch(run.network());
    Vec3 middle = Vec3::Zero();
    const auto look = [&](const sim::Snapshot& now) {
      watch.look(now);
      middle = middleOf(nodes, now.positions);
    };
    const int looks = static_cast<int>(kSleepLooks * until / 2.0);
    if (const sim::Status ran = run.looking(looks, until / 2.0, look); !ran) return ran.problem();
    const Vec3 halfway = middle;
    if (const sim::Status ran = run.looking(looks, until, look); !ran) return ran.problem();
    return ContactValues{(middle - halfway).norm(), watch.since()};
  };
}

ContactMeasure deepestUntil(double until, int looks) {
  return [until, looks](TimedRun& run) -> sim::Result<ContactValues> {
    const Meeting inLower(run.network(), 0, 1), inUpper(run.network(), 1, 0);
    double deepest = 0.0;
    const auto look = [&](const sim::Snapshot& now) {
      deepest = inUpper.deepest(now.positions, inLower.deepest(now.positions, deepest));
    };
    if (const sim::Status ran = run.looking(looks, until, look); !ran) return ran.problem();
    return ContactValues{deepest / smallestCell(run.network())};
  };
}

ContactMeasure restUntil(double until) {
  return [until](TimedRun& run) -> sim::Result<ContactValues> {
    SleepWatch watch(run.network());
    const auto look = [&](const sim::Snapshot& now) { watch.look(now); };
    if (const sim::Status ran = run.looking(static_cast<int>(kSleepLooks * until), until, look); !ran)
      return ran.problem();
    const auto end = run.simulation().snapshot().positions;
    double furthest = 0.0;
    for (std::size_t part = 0; part <= lastPart(run.network()); ++part) {
      const Nodes nodes = nodesOf(run.network(), part);
      furthest = std::max(furthest, (middleOf(nodes, end) - middleOf(nodes, run.network().positions)).norm());
    }
    return ContactValues{furthest, watch.since()};
  };
}

ContactMeasure reboundUntil(double until) {
  return [until](TimedRun& run) -> sim::Result<ContactValues> {
    const sim::Network& network = run.network();
    const Nodes nodes = nodesOf(network, lastPart(network));
    const auto momentumUp = [&](const std::vector<Vec3>& velocities) {
      double sum = 0.0;
      for (const sim::NodeIndex node : nodes) sum += network.masses[node] * velocities[node].z();
      return sum;
    };
    const double before = momentumUp(network.velocities);
    if (const sim::Status ran = run.to(until); !ran) return ran.problem();
    return ContactValues{-momentumUp(run.simulation().snapshot().velocities) / before};
  };
}

ContactMeasure violenceUntil(double until) {
  return [until](TimedRun& run) -> sim::Result<ContactValues> {
    double fastest = 0.0;
    const auto look = [&](const sim::Snapshot& now) {
      for (const Vec3& velocity : now.velocities) fastest = std::max(fastest, velocity.norm());
    };
    constexpr int kLooks = 500;
    if (const sim::Status ran = run.looking(kLooks, until, look); !ran) return ran.problem();
    return ContactValues{fastest, static_cast<double>(run.simulation().brokenBondCount())};
  };
}

ContactMeasure breakBy(double until) {
  return [until](TimedRun& run) -> sim::Result<ContactValues> {
    if (const sim::Status ran = run.toBreak(until); !ran) return ran.problem();
    const auto events = run.simulation().drainBreakEvents();
    if (events.empty()) return ContactValues{std::nullopt};
    return ContactValues{events.front().time};
  };
}

ContactMeasure costUntil(double until) {
  return [until](TimedRun& run) -> sim::Result<ContactValues> {
    if (const sim::Status ran = run.to(until); !ran) return ran.problem();
    return ContactValues{run.cpuSeconds()};
  };
}

}  // namespace app
