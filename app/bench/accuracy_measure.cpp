#include "app/bench/accuracy_measure.h"

#include <algorithm>
#include <cmath>

#include "app/bench/timing.h"

namespace app {
namespace {

using sim::Vec3;

double moment(const AccuracyScene& scene, int index) {
  return scene.until * (index + 1) / kMoments;
}

/// Where everything is at `time`, between two steps: the cubic through both states and their velocities,
/// whose error is of fourth order in the step.
std::vector<Vec3> between(const sim::Snapshot& before, const sim::Snapshot& after, double time) {
  const double step = after.time - before.time;
  const double s = (time - before.time) / step;
  std::vector<Vec3> positions(before.positions.size());
  for (std::size_t node = 0; node < positions.size(); ++node) {
    positions[node] = (1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s) * before.positions[node] +
                      s * (1.0 - s) * (1.0 - s) * step * before.velocities[node] +
                      s * s * (3.0 - 2.0 * s) * after.positions[node] -
                      s * s * (1.0 - s) * step * after.velocities[node];
  }
  return positions;
}

/// One way through one scene.
class Walk {
 public:
  Walk(const AccuracyScene& scene, sim::Simulation& simulation, double mostSeconds)
      : scene_(scene), simulation_(simulation), mostSeconds_(mostSeconds) {}

  /// To a moment on which a fixed step falls, unless the program divided it on the way, or past one.
  void toMoment(int index) {
    constexpr double kSlack = 1e-6;  // of a step: sums of steps are rounded
    const double time = moment(scene_, index);
    step([&] { return simulation_.time() + (1.0 + kSlack) * simulation_.step() < time; });
    sim::Snapshot now = simulation_.snapshot();
    while (course.done() && now.time < time - kSlack * simulation_.step()) {
      const sim::Snapshot before = std::move(now);
      step([&, done = false]() mutable { return !std::exchange(done, true); });
      now = simulation_.snapshot();
      if (now.time > time + kSlack * simulation_.step()) return record(now, between(before, now, time));
    }
    if (course.done()) record(now);
  }
  void toBreak() {
    // A method that never tears it would go on for ever.
    const double last = 4.0 * scene_.until;
    step([&] { return simulation_.brokenBondCount() == 0 && simulation_.time() < last; });
    const auto events = simulation_.drainBreakEvents();
    if (!events.empty()) course.firstBreak = events.front();
  }

  Course course;

 private:
  template <class Condition>
  void step(Condition goesOn) {
    const double start = threadSeconds();
    while (course.done() && goesOn()) {
      if (const auto status = simulation_.stepOnce(); !status) course.status = "blown up";
      if (course.cpuSeconds + threadSeconds() - start > mostSeconds_) course.status = "too slow";
    }
    course.cpuSeconds += threadSeconds() - start;
  }
  void record(const sim::Snapshot& snapshot) { record(snapshot, snapshot.positions); }
  void record(const sim::Snapshot& snapshot, std::vector<Vec3> positions) {
    const sim::Energy& energy = snapshot.ledger.energy;
    residual_ = std::max(residual_, std::abs(energy.residual));
    scale_ = std::max(scale_, energy.kinetic + energy.elastic + energy.contact);
    course.energyError = scale_ > 0.0 ? residual_ / scale_ : 0.0;
    course.positions.push_back(std::move(positions));
  }

  const AccuracyScene& scene_;
  sim::Simulation& simulation_;
  double mostSeconds_;
  double residual_ = 0.0;
  double scale_ = 0.0;
};

double strainOf(const AccuracyScene& scene, const std::vector<Vec3>& positions, sim::NodeIndex a,
                sim::BondIndex bond) {
  const sim::NodeIndex b = scene.network.bondEnds[bond];
  return (positions[b] - positions[a]).norm() / scene.network.bond(bond).restLength - 1.0;
}

Vec3 middleOf(const AccuracyScene& scene, const sim::BreakEvent& event) {
  return 0.5 * (scene.network.positions[event.a] + scene.network.positions[event.b]);
}

}  // namespace

Course follow(const AccuracyScene& scene, const Stepping& stepping, double mostSeconds) {
  sim::Settings settings = scene.settings;
  settings.method = stepping.method;
  if (stepping.step) {
    const double whole = std::ceil(scene.until / kMoments / *stepping.step - 1e-9);
    settings.step = scene.until / kMoments / whole;
  }
  auto simulation = sim::Simulation::create(scene.network, scene.environment, scene.tracks, settings);
  if (!simulation) {
    Course refused;
    refused.status = "refused";
    return refused;
  }
  Walk walk(scene, **simulation, mostSeconds);
  walk.course.step = (*simulation)->step();
  for (int index = 0; index < kMoments && walk.course.done(); ++index) walk.toMoment(index);
  if (scene.untilBreak && walk.course.done()) walk.toBreak();
  return std::move(walk.course);
}

Course exactCourse(const AccuracyScene& scene) {
  Course course;
  for (int index = 0; index < kMoments; ++index)
    course.positions.push_back(scene.exact(moment(scene, index)));
  return course;
}

Errors errorsOf(const AccuracyScene& scene, const Course& course, const Course& better) {
  double off = 0.0, moved = 0.0, strainOff = 0.0, strained = 0.0;
  const sim::Network& network = scene.network;
  for (std::size_t m = 0; m < std::min(course.positions.size(), better.positions.size()); ++m) {
    const auto& mine = course.positions[m];
    const auto& right = better.positions[m];
    for (sim::NodeIndex a = 0; a < network.nodeCount(); ++a) {
      off += (mine[a] - right[a]).squaredNorm();
      moved += (right[a] - network.positions[a]).squaredNorm();
      for (sim::BondIndex bond = network.firstBond[a]; bond < network.firstBond[a + 1]; ++bond) {
        const double strain = strainOf(scene, right, a, bond);
        strainOff += std::pow(strainOf(scene, mine, a, bond) - strain, 2);
        strained += strain * strain;
      }
    }
  }
  Errors errors;
  errors.position = std::sqrt(off / moved);
  errors.strain = std::sqrt(strainOff / strained);
  if (course.firstBreak && better.firstBreak) {
    errors.breakTime = std::abs(course.firstBreak->time / better.firstBreak->time - 1.0);
    errors.breakPlace = (middleOf(scene, *course.firstBreak) - middleOf(scene, *better.firstBreak)).norm();
  }
  return errors;
}

}  // namespace app
