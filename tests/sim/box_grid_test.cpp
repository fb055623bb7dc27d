#include "sim/contact/box_grid.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "sim/base/random.h"

namespace {

using Box = Eigen::AlignedBox3d;
using sim::Vec3;

struct Placed {
  Box box;
  sim::FragmentId fragment = 0;
};

/// Boxes of about a centimetre, most in a heap, some as far away as they fly.
std::vector<Placed> scattered(std::uint64_t seed, std::size_t count) {
  std::vector<Placed> placed;
  std::uint64_t draw = 0;
  const auto next = [&] { return sim::uniformAt(seed, draw++); };
  for (std::size_t i = 0; i < count; ++i) {
    const double reach = next() < 0.9 ? 6.0 : 4000.0;
    const Vec3 middle = reach * (Vec3(next(), next(), next()) - Vec3::Constant(0.5));
    const Vec3 half = 0.1 * Vec3::Ones() + 0.6 * Vec3(next(), next(), next());
    placed.push_back({Box(middle - half, middle + half), static_cast<sim::FragmentId>(4.0 * next())});
  }
  return placed;
}

}  // namespace

TEST_CASE(
    "a grid of boxes finds all of other fragments that overlap, once and in order, however far apart they "
    "are") {
  const auto seed = GENERATE(1U, 2U, 3U);
  const std::vector<Placed> placed = scattered(seed, 600);
  sim::BoxGrid grid(1.5);
  for (std::uint32_t i = 0; i < placed.size(); ++i) grid.add(i, placed[i].fragment, placed[i].box);
  grid.sort();
  std::vector<std::uint32_t> found;
  std::size_t pairs = 0;
  for (const std::uint32_t from : {0U, 300U}) {
    for (const Placed& one : placed) {
      grid.find(one.fragment, one.box, from, found);
      CHECK(std::ranges::is_sorted(found));
      CHECK(std::ranges::adjacent_find(found) == found.end());
      for (std::uint32_t i = 0; i < placed.size(); ++i) {
        const bool is = std::ranges::binary_search(found, i);
        const bool may = i >= from && placed[i].fragment != one.fragment;
        if (may && placed[i].box.intersects(one.box)) REQUIRE(is);
        // Floats are as coarse as this, a few thousand centimetres away.
        Box wide(one.box.min() - Vec3::Constant(1e-3), one.box.max() + Vec3::Constant(1e-3));
        if (is) REQUIRE((may && placed[i].box.intersects(wide)));
        pairs += is ? 1 : 0;
      }
    }
  }
  CHECK(pairs > 1000);
}
