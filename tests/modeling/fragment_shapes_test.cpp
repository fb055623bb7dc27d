#include <cmath>
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "modeling/exchange/shape_chunks.h"
#include "sim/base/random.h"

namespace {

/// A triangle that is known by its number.
std::array<modeling::ShapeVertex, 3> triangle(std::size_t number) {
  std::array<modeling::ShapeVertex, 3> corners{};
  for (std::size_t c = 0; c < 3; ++c) corners[c][c] = static_cast<float>(number + 1);
  return corners;
}

TEST_CASE("the chunks of a fragment's shapes make up each of them, nothing twice, and are few") {
  constexpr std::size_t kTriangles = 200;
  for (const std::size_t shapes : {1U, 2U, 3U, 8U, 37U}) {
    CAPTURE(shapes);
    modeling::ShapedFragment fragment;
    std::vector<std::set<float>> seen(shapes);
    const modeling::MaterialSide side(0, false);
    for (std::size_t shape = 0; shape < shapes; ++shape) {
      fragment.begin(3 * shape);
      for (std::size_t number = 0; number < kTriangles; ++number) {
        // From one shape to another, and some once more at the end.
        const auto at = [&](std::uint64_t which) {
          return sim::uniformAt(shapes, 2 * number + which) * static_cast<double>(shapes);
        };
        const auto now = static_cast<double>(shape);
        const bool again = number % 7 == 0 && shape + 1 == shapes;
        if (!again && (now < std::floor(std::min(at(0), at(1))) || now > std::max(at(0), at(1)))) continue;
        fragment.add(side, triangle(number));
        seen[shape].insert(static_cast<float>(number + 1));
      }
      fragment.end();
      fragment.goOn(3 * shape + 2);
    }
    REQUIRE(fragment.shapes().size() == shapes);
    CHECK(fragment.shapes().back().last == 3 * shapes - 1);
    const auto chunks = modeling::shapeChunks(fragment);
    for (std::size_t shape = 0; shape < shapes; ++shape) {
      std::multiset<float> found;
      std::size_t count = 0;
      for (const auto& chunk : chunks) {
        if (chunk.firstShape > shape || chunk.lastShape < shape) continue;
        ++count;
        for (const auto& [of, vertices] : chunk.triangles) {
          for (std::size_t i = 0; i < vertices.size(); i += 3)
            found.insert(fragment.vertices()[vertices[i]][0]);
        }
      }
      CHECK(found == std::multiset<float>(seen[shape].begin(), seen[shape].end()));
      CHECK(count <= (shape == 0 ? 1 : 2 + static_cast<std::size_t>(std::log2(shapes))));
    }
  }
}

}  // namespace
