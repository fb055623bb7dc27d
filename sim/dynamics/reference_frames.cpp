#include "sim/dynamics/reference_frames.h"

#include <algorithm>
#include <cmath>

#include "sim/base/parallel.h"

namespace sim {
namespace {

/// Blocks whose sums are added up one after the other. Fixed, so that results do not depend on the number of
/// threads.
constexpr std::size_t kBlocksPerSum = 64;

using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

ReferenceFrame frameAt(const Vec3& origin) {
  ReferenceFrame frame{};
  for (std::size_t k = 0; k < 3; ++k) {
    frame.rotation[4 * k] = 1.0;
    frame.origin[k] = origin[static_cast<Eigen::Index>(k)];
  }
  return frame;
}

/// What turns the axes nearer to the polar factor of P, rad: a step of Newton's method where they are near,
/// and one that is shorter but safe where they are far (M. Mueller, J. Bender, N. Chentanez, M. Macklin, "A
/// robust method to extract the rotational part of deformations", MIG 2016).
Vec3 turnTowards(const Eigen::Matrix3d& products, const Eigen::Matrix3d& axes) {
  constexpr double kNear = 0.3;       // rad
  constexpr double kFlatness = 1e-9;  // what lies on a line has a turn that does not matter
  const Eigen::Matrix3d stretch = products * axes.transpose();
  const Vec3 moment(stretch(2, 1) - stretch(1, 2), stretch(0, 2) - stretch(2, 0),
                    stretch(1, 0) - stretch(0, 1));
  const double weight = std::abs(stretch.trace());
  if (!(weight > 0.0)) return Vec3::Zero();
  const Eigen::Matrix3d inertia =
      weight * (1.0 + kFlatness) * Eigen::Matrix3d::Identity() - 0.5 * (stretch + stretch.transpose());
  const Vec3 newton = inertia.ldlt().solve(moment);
  return newton.norm() < kNear ? newton : moment / weight;
}

/// The rotation nearest to a sum of products (now)(reference)^T, from one near it. Where little is left to
/// turn, a frame is good enough: forces do not depend on it but by rounding.
RowMajor3 rotationOf(const Eigen::Matrix3d& products, const RowMajor3& near) {
  constexpr int kMostTurns = 200;
  constexpr double kLittle = 1e-4;  // rad; the next Newton step would be its square
  Eigen::Quaterniond turned{Eigen::Matrix3d(near)};
  for (int i = 0; i < kMostTurns; ++i) {
    const Vec3 turn = turnTowards(products, turned.toRotationMatrix());
    const double angle = turn.norm();
    if (!std::isfinite(angle) || angle == 0.0) break;
    turned = Eigen::Quaterniond(Eigen::AngleAxisd(angle, turn / angle)) * turned;
    turned.normalize();
    if (angle < kLittle) break;
  }
  return turned.toRotationMatrix();
}

}  // namespace

ReferenceFrames::ReferenceFrames(const Network& network, const Components& components)
    : shape_(network.nodeCount(), 4),
      remainder_(network.nodeCount(), 5),
      displacement_(network.nodeCount(), 6),
      velocity_(network.nodeCount(), 7),
      nextDisplacement_(network.nodeCount(), 8),
      nextVelocity_(network.nodeCount(), 9),
      mixed_(NodeVectors::paddedCount(network.nodeCount()) / kBlockNodes) {
  std::vector<Vec3> centres(components.births().size(), Vec3::Zero());
  std::vector<double> counts(centres.size(), 0.0);
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    centres[components.of(node)] += network.positions[node];
    counts[components.of(node)] += 1.0;
  }
  for (std::size_t fragment = 0; fragment < centres.size(); ++fragment) {
    centres[fragment] /= counts[fragment];
    frames_.push_back(frameAt(centres[fragment]));
  }
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    const Vec3 arm = network.positions[node] - centres[components.of(node)];
    shape_.set(node, arm);
    remainder_.set(node, arm - shape_.get(node));
  }
  nameFrames(components);
}

void ReferenceFrames::noteBirths(const Components& components) {
  for (std::size_t fragment = frames_.size(); fragment < components.births().size(); ++fragment) {
    const ReferenceFrame frame = frames_[components.births()[fragment].parent];
    frames_.push_back(frame);
  }
  nameFrames(components);
}

void ReferenceFrames::nameFrames(const Components& components) {
  frameOfNode_.assign(components.fragmentOfNode().begin(), components.fragmentOfNode().end());
  // Padding is as the last node, so that it mixes nothing.
  frameOfNode_.resize(mixed_.size() * kBlockNodes, frameOfNode_.empty() ? 0 : frameOfNode_.back());
  for (std::size_t block = 0; block < mixed_.size(); ++block) {
    const auto first = frameOfNode_.begin() + static_cast<std::ptrdiff_t>(block * kBlockNodes);
    mixed_[block] = std::any_of(first, first + kBlockNodes, [&](std::uint32_t id) { return id != *first; });
  }
}

/// Of consecutive nodes of one frame, about the frame of before, which is near.
struct ReferenceFrames::Sums {
  std::uint32_t frame = 0;
  double count = 0.0;
  Vec3 shape = Vec3::Zero();
  Vec3 position = Vec3::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();

  void operator+=(const Sums& other) {
    count += other.count;
    shape += other.shape;
    position += other.position;
    products += other.products;
  }
};

void ReferenceFrames::sumUp(const NodeVectors& positions, std::span<const std::uint32_t> blocks,
                            std::vector<Sums>& sums) const {
  for (const std::size_t block : blocks) {
    const std::size_t end = std::min(positions.size(), (block + 1) * kBlockNodes);
    for (std::size_t node = block * kBlockNodes; node < end; ++node) {
      if (sums.empty() || sums.back().frame != frameOfNode_[node]) sums.push_back({frameOfNode_[node]});
      const ReferenceFrame& frame = frames_[frameOfNode_[node]];
      const Vec3 shape = shapeAt(node) - Eigen::Map<const Vec3>(frame.centre);
      const Vec3 position = positions.get(node) - Eigen::Map<const Vec3>(frame.origin);
      Sums& sum = sums.back();
      sum.count += 1.0;
      sum.shape += shape;
      sum.position += position;
      sum.products += position * shape.transpose();
    }
  }
}

void ReferenceFrames::fit(const NodeVectors& positions, const Activity& activity) {
  const std::span<const std::uint32_t> blocks = activity.activeBlocks();
  std::vector<std::vector<Sums>> parts((blocks.size() + kBlocksPerSum - 1) / kBlocksPerSum);
  parallelFor(parts.size(), [&](std::size_t part) {
    const std::size_t first = part * kBlocksPerSum;
    sumUp(positions, blocks.subspan(first, std::min(kBlocksPerSum, blocks.size() - first)), parts[part]);
  });
  std::vector<Sums> sums(frames_.size());
  for (const std::vector<Sums>& part : parts) {
    for (const Sums& run : part) sums[run.frame] += run;
  }
  for (std::size_t fragment = 0; fragment < frames_.size(); ++fragment) {
    const Sums& sum = sums[fragment];
    if (sum.count == 0.0 || !activity.deforms(static_cast<FragmentId>(fragment))) continue;
    ReferenceFrame& frame = frames_[fragment];
    const Eigen::Matrix3d products = sum.products - sum.position * sum.shape.transpose() / sum.count;
    Eigen::Map<RowMajor3> rotation(frame.rotation);
    rotation = rotationOf(products, rotation);
    Eigen::Map<Vec3>(frame.centre) += sum.shape / sum.count;
    Eigen::Map<Vec3>(frame.origin) += sum.position / sum.count;
  }
  displaced_ = false;
}

void ReferenceFrames::noteStepped() {
  std::swap(displacement_, nextDisplacement_);
  std::swap(velocity_, nextVelocity_);
  displaced_ = true;
}

FloatReference ReferenceFrames::describe(const BondLayout& layout, bool displaceNext) {
  FloatReference reference{};
  reference.frames = frames_.data();
  reference.frameOfNode = frameOfNode_.data();
  reference.mixed = mixed_.data();
  for (std::size_t k = 0; k < 3; ++k) {
    reference.position[k] = shape_.axis(k);
    reference.remainder[k] = remainder_.axis(k);
    reference.displacement[k] = displacement_.axis(k);
    reference.velocity[k] = velocity_.axis(k);
    reference.nextDisplacement[k] = displaceNext ? nextDisplacement_.axis(k) : nullptr;
    reference.nextVelocity[k] = displaceNext ? nextVelocity_.axis(k) : nullptr;
  }
  reference.constants = layout.floatConstants();
  reference.lanes = layout.floatLanes();
  reference.anyExact = layout.hasExact();
  return reference;
}

bool ReferenceFrames::read(ByteReader& reader, std::size_t fragments, std::vector<ReferenceFrame>& frames) {
  const auto finite = [](const ReferenceFrame& frame) {
    return std::ranges::all_of(frame.rotation, [](double x) { return std::isfinite(x); }) &&
           std::ranges::all_of(frame.origin, [](double x) { return std::isfinite(x); }) &&
           std::ranges::all_of(frame.centre, [](double x) { return std::isfinite(x); });
  };
  return reader.readVector(frames) && frames.size() == fragments && std::ranges::all_of(frames, finite);
}

void ReferenceFrames::restore(std::vector<ReferenceFrame> frames, const Components& components) {
  frames_ = std::move(frames);
  nameFrames(components);
  displaced_ = false;
}

std::size_t ReferenceFrames::memoryBytes() const {
  return 6 * shape_.memoryBytes() + frames_.capacity() * sizeof(ReferenceFrame) +
         frameOfNode_.capacity() * sizeof(std::uint32_t) + mixed_.capacity();
}

}  // namespace sim
