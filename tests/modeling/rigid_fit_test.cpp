#include "modeling/exchange/rigid_fit.h"

#include <numbers>

#include <catch2/catch.hpp>

#include "modeling/exchange/key_reduction.h"
#include "sim/base/random.h"
#include "sim/surface/surface_mesh.h"
#include "tests/support/flying_pieces.h"

namespace {

using modeling::Pose;
using sim::Vec3;

Vec3 randomVector(std::uint64_t seed, std::uint64_t index) {
  return {sim::normalAt(seed, 3 * index), sim::normalAt(seed, 3 * index + 1),
          sim::normalAt(seed, 3 * index + 2)};
}

Eigen::Quaterniond randomRotation(std::uint64_t seed) {
  const Vec3 turn = randomVector(seed, 1000);
  return Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
}

TEST_CASE("a rotation is found again from the points it turned, and mirrored points make no mirror") {
  for (std::uint64_t seed = 1; seed < 50; ++seed) {
    const Eigen::Quaterniond turn = randomRotation(seed);
    std::vector<Vec3> from, to, mirrored;
    for (std::uint64_t i = 0; i < 3 + seed % 10; ++i) {
      from.push_back(randomVector(seed, i));
      to.push_back(turn * from.back());
      mirrored.push_back(to.back().cwiseProduct(Vec3(1.0, 1.0, -1.0)));
    }
    const auto found = modeling::bestRotation(from, to, Eigen::Quaterniond::Identity());
    CHECK(found.angularDistance(turn) < 1e-7);
    const auto matrix = modeling::bestRotation(from, mirrored, turn).toRotationMatrix();
    CHECK(matrix.determinant() == Approx(1.0));
  }
}

TEST_CASE("the fit is the best: no small turn away from it comes nearer to shaken points") {
  const std::uint64_t seed = 7;
  std::vector<Vec3> from, to;
  for (std::uint64_t i = 0; i < 20; ++i) {
    from.push_back(randomVector(seed, i));
    to.push_back(randomRotation(seed) * from.back() + 0.1 * randomVector(seed + 1, i));
  }
  const auto error = [&](const Eigen::Quaterniond& rotation) {
    double sum = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) sum += (to[i] - rotation * from[i]).squaredNorm();
    return sum;
  };
  const auto best = modeling::bestRotation(from, to, Eigen::Quaterniond::Identity());
  for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())}) {
    for (const double angle : {-0.01, 0.01})
      CHECK(error(Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)) * best) > error(best));
  }
}

TEST_CASE("what points leave open stays as it was") {
  const auto before = Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vec3::UnitX()));
  SECTION("one point says nothing") {
    CHECK(modeling::bestRotation({Vec3::Zero()}, {Vec3::Zero()}, before).angularDistance(before) == 0.0);
  }
  SECTION("two points on an axis that kept its direction leave the turn about it as it was") {
    const std::vector<Vec3> line{Vec3::UnitX(), -Vec3::UnitX()};
    CHECK(modeling::bestRotation(line, line, before).angularDistance(before) < 1e-6);
  }
}

TEST_CASE("rigid pieces are followed to rounding, and what deforms is told") {
  const tests::MemoryTake take = tests::flyingPieces(3, 5);
  const sim::Snapshot& first = **take.frame(0);
  const auto fragments = modeling::finalFragments(first, **take.frame(4));
  REQUIRE(fragments.size() == 3);
  for (const auto& fragment : fragments) {
    CHECK(fragment.nodes.size() == 8);
    CHECK(fragment.radius == Approx(std::sqrt(0.75)));
    modeling::RigidMotion motion(first.positions, fragment.origin);
    for (std::size_t frame = 0; frame < 5; ++frame)
      motion.follow(fragment.nodes, (*take.frame(frame))->positions);
    CHECK(motion.residual().largest < 1e-9);
    CHECK(motion.residual().count == 8 * 4);

    sim::Snapshot stretched = **take.frame(4);
    stretched.positions[fragment.nodes.front()] += Vec3(0.08, 0.0, 0.0);
    motion.follow(fragment.nodes, stretched.positions);
    CHECK(motion.residual().largest > 0.03);
    CHECK(motion.residual().largest < 0.08);
  }
}

TEST_CASE("a fragment moves on as before when others have come off it") {
  const tests::MemoryTake take = tests::flyingPieces(3, 5);
  const sim::Snapshot& first = **take.frame(0);
  const auto piece = modeling::finalFragments(first, **take.frame(4))[1];
  modeling::RigidMotion whole(first.positions, piece.origin), lessened(first.positions, piece.origin);
  std::vector<sim::NodeIndex> nodes = piece.nodes;
  for (std::size_t frame = 0; frame < 5; ++frame) {
    if (frame > 2) nodes.resize(5);
    whole.follow(piece.nodes, (*take.frame(frame))->positions);
    lessened.follow(nodes, (*take.frame(frame))->positions);
    CHECK((whole.poses()[frame].position - lessened.poses()[frame].position).norm() < 1e-9);
    CHECK(whole.poses()[frame].rotation.angularDistance(lessened.poses()[frame].rotation) < 1e-7);
  }
}

double largestDeviation(const std::vector<Pose>& poses, const std::vector<std::size_t>& keys) {
  double largest = 0.0;
  for (std::size_t k = 0; k + 1 < keys.size(); ++k) {
    for (std::size_t at = keys[k]; at <= keys[k + 1]; ++at) {
      const double share = static_cast<double>(at - keys[k]) / static_cast<double>(keys[k + 1] - keys[k]);
      const Vec3 between = (1.0 - share) * poses[keys[k]].position + share * poses[keys[k + 1]].position;
      largest = std::max(largest, (between - poses[at].position).norm());
    }
  }
  return largest;
}

TEST_CASE("keys are left out as far as the tolerance allows, and no further") {
  std::vector<Pose> poses(101);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double t = static_cast<double>(i);
    // At rest, then off evenly, then along a parabola.
    const double height = i < 40 ? 0.0 : i < 70 ? t - 40.0 : t - 40.0 + 0.01 * (t - 70.0) * (t - 70.0);
    poses[i].position = Vec3(0.0, 1.0, height);
  }
  const auto exact = modeling::positionKeys(poses, 1e-9);
  CHECK(exact.size() == 2 + 1 + 30);
  const auto loose = modeling::positionKeys(poses, 0.05);
  CHECK(loose.size() < 15);
  CHECK(largestDeviation(poses, loose) <= 0.05);
  CHECK(largestDeviation(poses, loose) > 0.005);
  CHECK(modeling::positionKeys(std::vector<Pose>(50), 1e-9) == std::vector<std::size_t>{0});
}

TEST_CASE("a steady spin needs keys only as often as programs disagree on what lies between") {
  std::vector<Pose> poses(91);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double angle = static_cast<double>(i) * std::numbers::pi / 180.0;
    poses[i].rotation = Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
  }
  // Interpolating components is off by up to 2 sin of a fifth of a degree in 90 degrees, at a radius of 10
  // cm.
  CHECK(modeling::rotationKeys(poses, 10.0, 1.0).size() == 2);
  const auto fine = modeling::rotationKeys(poses, 10.0, 1e-4);
  CHECK(fine.size() > 2);
  CHECK(fine.size() < 30);
}

}  // namespace
