#include "modeling/preflight/step_count.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/control/driven.h"

namespace modeling {
namespace {

using sim::Vec3;

/// The duration is looked at in so many parts.
constexpr int kParts = 200;
/// Of the speed at which a soft thing lands, what its fastest node keeps while it is shaken, on the average.
constexpr double kKeptSpeed = 0.75;
/// cm: as near to a collider counts as landed.
constexpr double kNear = 1e-3;

/// A fragment that flies as a point would, with the box it began with.
struct Flight {
  Vec3 velocity = Vec3::Zero();  ///< cm/s
  Vec3 moved = Vec3::Zero();     ///< cm
  Eigen::AlignedBox3d box;       ///< at the start
  std::array<bool, 8> landed{};  ///< by corner
  double speedOnLanding = 0.0;   ///< cm/s; 0: it still flies

  bool flies() const { return speedOnLanding == 0.0; }
  double speed() const { return flies() ? velocity.norm() : kKeptSpeed * speedOnLanding; }
};

std::vector<Flight> flightsOf(const sim::Simulation& simulation) {
  const sim::Snapshot start = simulation.snapshot();
  const std::vector<double>& masses = simulation.network().masses;
  std::vector<std::uint8_t> held(start.fragments.size(), 0);
  std::vector<double> fastest(start.fragments.size(), 0.0);
  for (std::size_t node = 0; node < masses.size(); ++node) {
    const auto found = std::ranges::lower_bound(start.broken->fragments, start.broken->fragmentOfNode[node],
                                                {}, &sim::Fragment::id);
    const auto fragment = static_cast<std::size_t>(found - start.broken->fragments.begin());
    if (fragment >= held.size()) continue;
    if (!std::isfinite(masses[node])) held[fragment] = 1;
    fastest[fragment] = std::max(fastest[fragment], start.velocities[node].norm());
  }
  std::vector<Flight> flights;
  for (std::size_t f = 0; f < start.fragments.size(); ++f) {
    Flight& flight = flights.emplace_back();
    flight.velocity = start.fragments[f].velocity;
    flight.box = {start.fragments[f].boxMin, start.fragments[f].boxMax};
    // What turns is faster at its rim; what is held stays about as fast as it is.
    if (held[f] != 0)
      flight.speedOnLanding = std::max(fastest[f] / kKeptSpeed, std::numeric_limits<double>::min());
  }
  return flights;
}

bool isIn(const std::vector<sim::Collider>& colliders, const Vec3& point, double time) {
  return std::ranges::any_of(colliders, [&](const sim::Collider& collider) {
    return collider.activeAt(time) && sim::intrusion(collider, point).depth > -kNear;
  });
}

/// On by `seconds`. It has landed when each of its corners has met something.
void fly(Flight& flight, const Vec3& gravity, const std::vector<sim::Collider>& colliders, double time,
         double seconds) {
  if (!flight.flies()) return;
  flight.moved += seconds * (flight.velocity + 0.5 * seconds * gravity);
  flight.velocity += seconds * gravity;
  bool all = true;
  for (std::size_t corner = 0; corner < flight.landed.size(); ++corner) {
    const auto which = static_cast<Eigen::AlignedBox3d::CornerType>(corner);
    flight.landed[corner] =
        flight.landed[corner] || isIn(colliders, flight.box.corner(which) + flight.moved, time);
    all = all && flight.landed[corner];
  }
  if (all) flight.speedOnLanding = std::max(flight.velocity.norm(), std::numeric_limits<double>::min());
}

}  // namespace

StepCount expectedSteps(const sim::Simulation& simulation, const sim::Environment& environment,
                        const std::vector<sim::Track>& tracks, bool freezesInFlight, double duration) {
  std::vector<Flight> flights = flightsOf(simulation);
  const double part = duration / kParts;
  std::vector<sim::Simulation::Pace> paces;
  for (int i = 0; i < kParts; ++i) {
    const double time = (i + 0.5) * part;
    const Vec3 gravity = sim::gravityAt(tracks, environment.gravity, time);
    double speed = 0.0;
    for (Flight& flight : flights) {
      fly(flight, gravity, environment.colliders, time, part);
      speed = std::max(speed, flight.speed());
    }
    const bool allFly = std::ranges::all_of(flights, [](const Flight& flight) { return flight.flies(); });
    const bool someLie = std::ranges::any_of(
        flights, [](const Flight& flight) { return std::ranges::count(flight.landed, true) > 0; });
    paces.push_back({time, speed, !(freezesInFlight && allFly), someLie});
  }
  StepCount count;
  const std::vector<double> steps = simulation.stepsAt(paces);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    count.all += part / steps[i];
    if (!paces[i].deforms) count.rigid += part / steps[i];
  }
  count.all = std::ceil(count.all);
  return count;
}

}  // namespace modeling
