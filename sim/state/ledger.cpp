#include "sim/state/ledger.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {

/// Past this many times the energy there ever was to have, the motion has blown up.
constexpr double kBlowUp = 10.0;
/// cm/s: motion so slow that it counts as rest when judging energies.
constexpr double kSlowest = 1e-3;

}  // namespace

Vec3 Ledger::massMoved(const NodeVectors& position) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t node = 0; node < position.size(); ++node) {
    const double mass = network_->masses[node];
    if (std::isfinite(mass)) sum += mass * (position.get(node) - network_->positions[node]);
  }
  return sum;
}

LedgerRow Ledger::draw(double time, double step, const NodeVectors& position, const NodeVectors& velocity,
                       const Energy& present, const Vec3& gravity) const {
  LedgerRow row;
  row.time = time;
  row.step = step;
  row.energy = flows_;
  row.energy.elastic = present.elastic;
  row.energy.contact = present.contact;
  row.energy.dissipated += present.dissipated;
  row.energy.outsideWork += present.outsideWork;
  for (std::size_t node = 0; node < position.size(); ++node) {
    const double mass = network_->masses[node];
    if (!std::isfinite(mass)) continue;
    const Vec3 moves = velocity.get(node);
    row.energy.kinetic += 0.5 * mass * moves.squaredNorm();
    row.linearMomentum += mass * moves;
    row.angularMomentum += mass * position.get(node).cross(moves);
  }
  row.energy.gravity = -gravity.dot(massMoved(position));
  row.energy.residual =
      row.energy.mechanical() + row.energy.dissipated + row.energy.released - row.energy.outsideWork - start_;
  return row;
}

void Ledger::begin(const LedgerRow& row, double kept) {
  start_ = row.energy.mechanical();
  lowest_ = start_;
  lowestKept_ = kept;
  startActive_ = scale_ = row.energy.kinetic + row.energy.elastic + row.energy.contact;
}

bool Ledger::watch(const LedgerRow& row, double kept) {
  const double unexplained = row.energy.mechanical() - row.energy.outsideWork;
  const double unexplainedKept = kept - row.energy.outsideWork;
  const double active = row.energy.kinetic + row.energy.elastic + row.energy.contact;
  lowest_ = std::min(lowest_, unexplained);
  lowestKept_ = std::min(lowestKept_, unexplainedKept);
  largestRise_ = std::max(largestRise_, std::min(unexplained - lowest_, unexplainedKept - lowestKept_));
  scale_ = std::max(scale_, active);
  double mass = 0.0;
  for (const double one : network_->masses) mass += std::isfinite(one) ? one : 0.0;
  const double budget =
      startActive_ + std::max(0.0, row.energy.outsideWork) + std::max(0.0, -row.energy.gravity);
  return std::isfinite(active) && active <= kBlowUp * budget + mass * kSlowest * kSlowest;
}

double Ledger::maxRise() const {
  return scale_ > 0.0 ? largestRise_ / scale_ : 0.0;
}

double Ledger::gravityWork(const NodeVectors& position, const Vec3& before, const Vec3& after) const {
  return -(after - before).dot(massMoved(position));
}

void Ledger::takeOver(const Ledger& other) {
  const Network* const network = network_;
  *this = other;
  network_ = network;
}

void Ledger::save(ByteWriter& writer) const {
  for (const double value : {flows_.dissipated, flows_.released, flows_.outsideWork, start_, lowest_,
                             lowestKept_, largestRise_, scale_, startActive_}) {
    writer.put(value);
  }
}

bool Ledger::load(ByteReader& reader) {
  for (double* value : {&flows_.dissipated, &flows_.released, &flows_.outsideWork, &start_, &lowest_,
                        &lowestKept_, &largestRise_, &scale_, &startActive_}) {
    reader.read(*value);
  }
  return reader.ok();
}

}  // namespace sim
