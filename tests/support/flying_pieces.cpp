#include "tests/support/flying_pieces.h"

#include <cmath>

#include <Eigen/Geometry>

#include "sim/base/random.h"
#include "tests/support/grid_network.h"

namespace tests {

namespace {

using sim::Vec3;

constexpr double kFramesPerSecond = 24.0;

/// Which piece a corner of the bar belongs to.
std::size_t pieceAt(const Vec3& corner) {
  return static_cast<std::size_t>(corner.z()) / 2;
}

/// Nodes of a piece stand in layers of two.
std::size_t pieceOf(sim::NodeIndex node, std::size_t pieces) {
  const std::size_t layers = 2 * pieces;
  return node % layers / 2;
}

/// Folds the bar up into a block, to and fro, so that a thousand pieces are no longer than single precision
/// carries, and what breaks between two of them is small.
Vec3 folded(const Vec3& corner) {
  const std::size_t piece = pieceAt(corner);
  const auto wound = [](std::size_t index, bool back) {
    return static_cast<double>(back ? 9 - index : index);
  };
  const std::size_t row = piece / 10;
  const std::size_t layer = row / 10;
  return {corner.x() + 2.0 * wound(piece % 10, row % 2 == 1),
          corner.y() + 2.0 * wound(row % 10, layer % 2 == 1),
          std::fmod(corner.z(), 2.0) + 2.0 * static_cast<double>(layer)};
}

/// Where a piece is after `time` seconds: thrown, and spinning at up to a turn a second about any axis.
Eigen::Isometry3d moved(std::size_t piece, double time) {
  Eigen::Isometry3d now = Eigen::Isometry3d::Identity();
  if (piece == 0) return now;
  const auto random = [&](std::uint64_t which) { return sim::uniformAt(piece, which) - 0.5; };
  const Vec3 centre = folded(Vec3(0.0, 0.0, 2.0 * static_cast<double>(piece))) + Vec3::Constant(0.5);
  const Vec3 axis = Vec3(random(0), random(1), random(2) + 1.0).normalized();
  const Vec3 thrown(30.0 * random(3), 30.0 * random(4), 100.0);
  now.translate(Vec3(centre + time * thrown - 0.5 * time * time * 981.0 * Vec3::UnitZ()));
  now.rotate(Eigen::AngleAxisd(12.0 * random(5) * time, axis));
  now.translate(Vec3(-centre));
  return now;
}

/// Breaks what joins nodes of different fragments.
void breakBetweenFragments(const sim::Network& network, sim::Broken& broken) {
  for (sim::CellIndex cell = 0; cell < network.cellCount(); ++cell) {
    for (const sim::NodeIndex node : network.cells[cell]) {
      if (broken.fragmentOfNode[node] != broken.fragmentOfNode[network.cells[cell][0]])
        broken.cells[cell] = 1;
    }
  }
  for (sim::NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (sim::BondIndex bond = network.firstBond[a]; bond < network.firstBond[a + 1]; ++bond) {
      const bool between = broken.fragmentOfNode[a] != broken.fragmentOfNode[network.bondEnds[bond]];
      broken.bonds[bond] = between ? 1 : 0;
    }
  }
}

sim::Snapshot frameOf(const sim::Network& network, std::size_t pieces, std::size_t number) {
  sim::Snapshot frame = sim::momentAtRest(network);
  frame.time = static_cast<double>(number) / kFramesPerSecond;
  frame.stepCount = number;
  sim::Broken broken = *frame.broken;
  for (sim::NodeIndex node = 0; node < network.nodeCount(); ++node) {
    const std::size_t piece = pieceOf(node, pieces);
    frame.positions[node] = moved(piece, frame.time) * network.positions[node];
    if (number > 0) broken.fragmentOfNode[node] = static_cast<sim::FragmentId>(piece);
  }
  if (number == 0) {
    broken.fragments = {{.id = 0, .nodeCount = static_cast<std::uint32_t>(network.nodeCount())}};
    frame.broken = sim::sealed(std::move(broken));
    frame.fragments = {{.id = 0}};
    return frame;
  }
  breakBetweenFragments(network, broken);
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    const auto id = static_cast<sim::FragmentId>(piece);
    broken.fragments.push_back({.id = id,
                                .parent = piece == 0 ? sim::kNone : 0U,
                                .born = piece == 0 ? 0.0 : 0.01,
                                .nodeCount = 8,
                                .mass = 8.0 + static_cast<double>(piece)});
    frame.fragments.push_back({.id = id});
  }
  frame.broken = sim::sealed(std::move(broken));
  return frame;
}

}  // namespace

MemoryTake flyingPieces(std::size_t pieces, std::size_t frames) {
  const sim::Network network = gridNetwork(1, 1, 2 * static_cast<unsigned>(pieces) - 1, folded);
  std::vector<sim::Snapshot> made;
  for (std::size_t number = 0; number < frames; ++number) made.push_back(frameOf(network, pieces, number));
  return {network, std::move(made)};
}

MemoryTake crumblingBar(std::size_t pieces) {
  const sim::Network network = gridNetwork(1, 1, 2 * static_cast<unsigned>(pieces) - 1);
  std::vector<sim::Snapshot> made;
  for (std::size_t number = 0; number < pieces; ++number) {
    sim::Snapshot& frame = made.emplace_back(sim::momentAtRest(network));
    frame.time = static_cast<double>(number) / kFramesPerSecond;
    frame.stepCount = number;
    sim::Broken broken = *frame.broken;
    broken.fragments = {{.id = 0, .mass = 8.0}};
    frame.fragments = {{.id = 0}};
    for (sim::NodeIndex node = 0; node < network.nodeCount(); ++node) {
      // The last piece comes off in frame 1, and so on; each rises from then on.
      const std::size_t born = pieces - pieceOf(node, pieces);
      if (born > number) continue;
      broken.fragmentOfNode[node] = static_cast<sim::FragmentId>(born);
      frame.positions[node].x() += 0.5 * static_cast<double>(number - born);
    }
    for (std::size_t id = 1; id <= number; ++id) {
      broken.fragments.push_back({.id = static_cast<sim::FragmentId>(id),
                                  .parent = 0,
                                  .born = static_cast<double>(id) / kFramesPerSecond,
                                  .mass = 8.0});
      frame.fragments.push_back({.id = static_cast<sim::FragmentId>(id)});
    }
    breakBetweenFragments(network, broken);
    frame.broken = sim::sealed(std::move(broken));
  }
  return {network, std::move(made)};
}

sim::SurfaceMesh surfaceOfPieces(const MemoryTake& take, std::size_t frame) {
  sim::Snapshot moment = **take.frame(take.frameCount() - 1);
  moment.positions = (*take.frame(frame))->positions;
  return sim::SurfaceBuilder(take.network()).build(moment);
}

}  // namespace tests
