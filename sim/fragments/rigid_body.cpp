#include "sim/fragments/rigid_body.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace sim {
namespace {

/// Moments of inertia below this share of the largest belong to an almost straight row of nodes. Contacts
/// push at the nodes, so what would spin it about itself is little more than rounding.
constexpr double kNoExtent = 1e-6;
/// So many times what it bears for long is too much at once, however short.
constexpr double kSudden = 3.0;

/// Sine and cosine of half the angle by their series where the next term is below rounding: steps are small.
constexpr double kSmallAngle = 1e-3;

Eigen::Quaterniond turned(const Eigen::Quaterniond& from, const Vec3& angularVelocity, double step) {
  const Vec3 rotation = step * angularVelocity;
  const double squared = rotation.squaredNorm();
  if (!(squared > 0.0)) return from;
  double real = 1.0 - squared / 8.0;
  double share = 0.5 - squared / 48.0;
  if (squared > kSmallAngle * kSmallAngle) {
    const double angle = std::sqrt(squared);
    real = std::cos(0.5 * angle);
    share = std::sin(0.5 * angle) / angle;
  }
  const Vec3 imaginary = share * rotation;
  return (Eigen::Quaterniond(real, imaginary.x(), imaginary.y(), imaginary.z()) * from).normalized();
}

}  // namespace

RigidBody::RigidBody(const Network& network, FragmentId fragment, std::span<const NodeIndex> nodes,
                     const Motion& motion)
    : fragment_(fragment), nodes_(nodes.begin(), nodes.end()) {
  for (const NodeIndex node : nodes_) {
    const double mass = network.masses[node];
    mass_ += mass;
    centre_ += mass * motion.position.get(node);
    velocity_ += mass * motion.velocity.get(node);
  }
  centre_ /= mass_;
  velocity_ /= mass_;
  if (nodes_.size() == 1) {
    // Without the rounding of the mean, which would be an extent, and spin.
    centre_ = motion.position.get(nodes_[0]);
    velocity_ = motion.velocity.get(nodes_[0]);
    shape_.assign(1, Vec3::Zero());
    return;
  }
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (const NodeIndex node : nodes_) {
    const double mass = network.masses[node];
    const Vec3 at = motion.position.get(node) - centre_;
    inertia += mass * (at.squaredNorm() * Eigen::Matrix3d::Identity() - at * at.transpose());
    angularMomentum_ += mass * at.cross(motion.velocity.get(node) - velocity_);
    radius_ = std::max(radius_, at.norm());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(inertia);
  Eigen::Matrix3d worldFromBody = axes.eigenvectors();
  if (worldFromBody.determinant() < 0.0) worldFromBody.col(0) *= -1.0;
  worldFromBody_ = Eigen::Quaterniond(worldFromBody).normalized();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double moment = axes.eigenvalues()[k];
    inverseInertia_[k] = moment > kNoExtent * axes.eigenvalues()[2] ? 1.0 / moment : 0.0;
  }
  shape_.reserve(nodes_.size());
  for (const NodeIndex node : nodes_)
    shape_.push_back(worldFromBody_.conjugate() * (motion.position.get(node) - centre_));
}

Vec3 RigidBody::angularVelocityAt(const Eigen::Quaterniond& worldFromBody,
                                  const Vec3& angularMomentum) const {
  if (!(radius_ > 0.0)) return Vec3::Zero();
  return worldFromBody * inverseInertia_.cwiseProduct(worldFromBody.conjugate() * angularMomentum);
}

RigidBody::Rates RigidBody::ratesAfter(const Vec3& change, const Vec3& torqueImpulse) const {
  return {velocity_ + change, angularVelocityAt(worldFromBody_, angularMomentum_ + torqueImpulse)};
}

Vec3 RigidBody::angularVelocity() const {
  return angularVelocityAt(worldFromBody_, angularMomentum_);
}

double RigidBody::fastest() const {
  return velocity_.norm() + inverseInertia_.maxCoeff() * angularMomentum_.norm() * radius_;
}

double RigidBody::kineticEnergy() const {
  return 0.5 * mass_ * velocity_.squaredNorm() + 0.5 * angularVelocity().dot(angularMomentum_);
}

Vec3 RigidBody::vibration(std::size_t index, const Vec3& velocity) const {
  return velocity - velocity_ - angularVelocity().cross(arm(index));
}

void RigidBody::drift(double step, const Vec3& velocity) {
  centre_ += step * velocity;
  if (!(radius_ > 0.0)) return;
  const Eigen::Quaterniond midway = turned(worldFromBody_, angularVelocity(), 0.5 * step);
  worldFromBody_ = turned(worldFromBody_, angularVelocityAt(midway, angularMomentum_), step);
}

void RigidBody::place(NodeVectors& positions) const {
  const Eigen::Matrix3d turn = worldFromBody_.toRotationMatrix();
  for (std::size_t i = 0; i < nodes_.size(); ++i) positions.set(nodes_[i], centre_ + turn * shape_[i]);
}

void RigidBody::placeVelocities(NodeVectors& velocities, const Rates& rates) const {
  const Eigen::Matrix3d turn = worldFromBody_.toRotationMatrix();
  for (std::size_t i = 0; i < nodes_.size(); ++i) velocities.set(nodes_[i], rates.at(turn * shape_[i]));
}

void RigidBody::placeTouched(Motion& motion) const {
  if (!(radius_ > 0.0)) {
    for (const std::uint32_t place : touched_) {
      motion.position.set(nodes_[place], centre_);
      motion.velocity.set(nodes_[place], velocity_);
    }
    return;
  }
  const Rates now = rates();
  // The same arithmetic as in place(), so that it does not show which of the two was called last.
  const Eigen::Matrix3d turn = worldFromBody_.toRotationMatrix();
  for (const std::uint32_t place : touched_) {
    const Vec3 at = turn * shape_[place];
    motion.position.set(nodes_[place], centre_ + at);
    motion.velocity.set(nodes_[place], now.at(at));
  }
}

bool RigidBody::bears(double load, double seconds, double gravity) {
  if (firstLoad_ < 0.0) firstLoad_ = load_ = load;
  load_ += (load - load_) * std::min(1.0, bearing_.time > 0.0 ? seconds / bearing_.time : 1.0);
  const double beside = firstLoad_ + mass_ * gravity * radius_;
  return load_ <= beside + bearing_.most && load <= beside + kSudden * bearing_.most;
}

void RigidBody::save(ByteWriter& writer) const {
  writer.put(fragment_);
  writer.putVector(nodes_);
  writer.putVector(shape_);
  writer.putVector(touched_);
  for (const double value : {mass_, radius_, gentleSpeed_, bearing_.most, bearing_.time, load_, firstLoad_})
    writer.put(value);
  for (const Vec3& vector : {inverseInertia_, centre_, velocity_, angularMomentum_}) writer.put(vector);
  for (const double value : worldFromBody_.coeffs()) writer.put(value);
}

bool RigidBody::load(ByteReader& reader, std::size_t nodeCount) {
  reader.read(fragment_);
  reader.readVector(nodes_);
  reader.readVector(shape_);
  reader.readVector(touched_);
  for (double* value : {&mass_, &radius_, &gentleSpeed_, &bearing_.most, &bearing_.time, &load_, &firstLoad_})
    reader.read(*value);
  for (Vec3* vector : {&inverseInertia_, &centre_, &velocity_, &angularMomentum_}) reader.read(*vector);
  for (double& value : worldFromBody_.coeffs()) reader.read(value);
  const auto isNode = [&](NodeIndex node) { return node < nodeCount; };
  const auto isPlace = [&](std::uint32_t place) { return place < nodes_.size(); };
  return reader.ok() && shape_.size() == nodes_.size() && std::ranges::all_of(nodes_, isNode) &&
         std::ranges::all_of(touched_, isPlace);
}

std::size_t RigidBody::memoryBytes() const {
  return sizeof(*this) + nodes_.capacity() * sizeof(NodeIndex) + shape_.capacity() * sizeof(Vec3) +
         touched_.capacity() * sizeof(std::uint32_t);
}

}  // namespace sim
