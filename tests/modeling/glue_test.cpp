#include "modeling/glue/glue.h"

#include <algorithm>
#include <ctime>
#include <random>
#include <set>

#include <catch2/catch.hpp>

#include "modeling/glue/nearest.h"
#include "modeling/shapes/quality.h"
#include "modeling/shapes/slab.h"
#include "sim/network/wedge.h"
#include "tests/modeling/shapes_teapot.h"

using modeling::GluePart;
using modeling::GlueSettings;
using modeling::NodeIndex;
using modeling::Vec3;

namespace {

GluePart unshaped(std::string name) {
  return {std::move(name), {}, {}, {}};
}

/// A block of nx x ny x nz unit cells with its low corner at `corner`.
GluePart block(const std::string& name, std::array<int, 3> cells, const Vec3& corner, double size = 1.0) {
  modeling::SlabShape shape;
  shape.size = size * Vec3(cells[0], cells[1], cells[2]);
  shape.resolution.counts = {cells[0], cells[1], cells[2]};
  const auto lattice = build(shape);
  REQUIRE(lattice.ok());
  GluePart part = unshaped(name);
  part.cells = lattice->cells;
  for (const Vec3& node : lattice->nodes)
    part.nodes.push_back(node + corner + 0.5 * Vec3(shape.size.x(), shape.size.y(), 0.0));
  return part;
}

GlueSettings gluing(std::size_t a, std::size_t b, double reach) {
  GlueSettings settings;
  settings.a = a;
  settings.b = b;
  settings.reach = reach;
  return settings;
}

modeling::GlueResult glued(const std::vector<GluePart>& parts, const std::vector<GlueSettings>& glues) {
  auto result = glue(parts, glues);
  INFO((result.ok() ? "" : result.problem().line()));
  REQUIRE(result.ok());
  return std::move(result).value();
}

/// Of the merged nodes.
std::vector<Vec3> positionsOf(const std::vector<GluePart>& parts, const modeling::GlueResult& result) {
  std::vector<Vec3> positions(result.nodeCount);
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t node = 0; node < parts[p].nodes.size(); ++node)
      if (result.gluedBy[p][node] == sim::kNone) positions[result.globalNode[p][node]] = parts[p].nodes[node];
  return positions;
}

/// The least scaled Jacobian of all cells that are left, wedges included.
double worstOf(const std::vector<GluePart>& parts, const modeling::GlueResult& result) {
  const std::vector<Vec3> positions = positionsOf(parts, result);
  double worst = 1.0;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (sim::CellIndex cell = 0; cell < parts[p].cells.size(); ++cell) {
      if (std::binary_search(result.droppedCells[p].begin(), result.droppedCells[p].end(), cell)) continue;
      sim::CellCorners nodes;
      for (std::size_t c = 0; c < 8; ++c) nodes[c] = result.globalNode[p][parts[p].cells[cell][c]];
      const auto corners = modeling::cornerPositions(positions, nodes);
      worst = std::min(worst, sim::isWedge(nodes) ? modeling::scaledJacobianOfWedge(corners)
                                                  : modeling::scaledJacobian(corners));
    }
  return worst;
}

/// Distinct pairs of corners of the cells of all parts, after gluing, without what gluing set to zero.
std::size_t liveBonds(const std::vector<GluePart>& parts, const modeling::GlueResult& result) {
  std::set<std::pair<NodeIndex, NodeIndex>> bonds;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (const auto& cell : parts[p].cells)
      for (const NodeIndex x : cell)
        for (const NodeIndex y : cell) {
          const auto by = result.gluedBy[p][x];
          const NodeIndex gx = result.globalNode[p][x], gy = result.globalNode[p][y];
          if (gx < gy && !(by != sim::kNone && by == result.gluedBy[p][y])) bonds.insert({gx, gy});
        }
  return bonds.size();
}

std::size_t allBonds(const GluePart& part) {
  std::set<std::pair<NodeIndex, NodeIndex>> bonds;
  for (const auto& cell : part.cells)
    for (const NodeIndex x : cell)
      for (const NodeIndex y : cell)
        if (x < y) bonds.insert({x, y});
  return bonds.size();
}

}  // namespace

TEST_CASE("Two blocks glued face to face are one block", "[glue]") {
  const std::vector<GluePart> parts{block("a", {2, 3, 4}, Vec3(0, 0, 4)),
                                    block("b", {2, 3, 4}, Vec3(0, 0, 0))};
  const auto result = glued(parts, {gluing(0, 1, 0.5)});
  CHECK(result.nodeCount == 3 * 4 * 9);
  REQUIRE(result.reports.size() == 1);
  const auto& report = result.reports[0];
  CHECK(report.a == "a");
  CHECK(report.b == "b");
  CHECK(report.nodesMerged == 3 * 4);
  // On the shared face: 2 x 4 + 3 x 3 edges and two diagonals for each of its 6 squares. All of them repeat
  // b's.
  CHECK(report.bondsZeroed == 2 * 4 + 3 * 3 + 2 * 6);
  CHECK(report.bondsDuplicate == 0);
  CHECK(report.cellsDropped == 0);
  CHECK(report.worstDistance == 0.0);
  CHECK(report.worstScaledJacobian == Approx(1.0));
  CHECK(liveBonds(parts, result) == allBonds(block("whole", {2, 3, 8}, Vec3::Zero())));
}

TEST_CASE("Merged nodes keep the order of parts and of nodes within a part", "[glue]") {
  const std::vector<GluePart> parts{block("a", {2, 2, 2}, Vec3(0, 0, 2)),
                                    block("b", {2, 2, 2}, Vec3(0, 0, 0))};
  const auto result = glued(parts, {gluing(0, 1, 0.5)});
  NodeIndex next = 0;
  std::vector<Vec3> positions(result.nodeCount, Vec3::Constant(std::nan("")));
  for (std::size_t p = 0; p < 2; ++p)
    for (std::size_t node = 0; node < parts[p].nodes.size(); ++node) {
      if (result.gluedBy[p][node] != sim::kNone) continue;
      CHECK(result.globalNode[p][node] == next++);
      positions[result.globalNode[p][node]] = parts[p].nodes[node];
    }
  CHECK(next == result.nodeCount);
  for (std::size_t p = 0; p < 2; ++p)
    for (std::size_t node = 0; node < parts[p].nodes.size(); ++node)
      CHECK((positions[result.globalNode[p][node]] - parts[p].nodes[node]).norm() < 1e-12);
}

TEST_CASE("Where parts overlap, cells glued whole are dropped, and nothing is there twice", "[glue]") {
  // The lowest layer of a lies in the highest of b.
  const std::vector<GluePart> parts{block("a", {2, 2, 3}, Vec3(0, 0, 2)),
                                    block("b", {2, 2, 3}, Vec3(0, 0, 0))};
  const auto result = glued(parts, {gluing(0, 1, 0.25)});
  CHECK(result.nodeCount == 3 * 3 * 6);
  CHECK(result.reports[0].nodesMerged == 18);
  CHECK(result.reports[0].cellsDropped == 4);
  CHECK(result.droppedCells[0].size() == 4);
  CHECK(result.droppedCells[1].empty());
  CHECK(liveBonds(parts, result) == allBonds(block("whole", {2, 2, 5}, Vec3::Zero())));
}

TEST_CASE("A gap is closed: glued nodes take b's place", "[glue]") {
  const std::vector<GluePart> parts{block("a", {2, 2, 2}, Vec3(0.1, 0, 2.2)),
                                    block("b", {2, 2, 2}, Vec3(0, 0, 0))};
  const auto preview = previewGlue(parts[0], parts[1], gluing(0, 1, 0.4));
  REQUIRE(preview.ok());
  CHECK(preview->pairs.size() == 9);
  CHECK(preview->worstDistance == Approx(std::hypot(0.1, 0.2)));
  const auto result = glued(parts, {gluing(0, 1, 0.4)});
  CHECK(result.reports[0].worstDistance == Approx(std::hypot(0.1, 0.2)));
  CHECK(result.reports[0].worstScaledJacobian < 1.0);
  CHECK(result.reports[0].worstCell != sim::kNone);
}

TEST_CASE("A glued to B glued to C ends at C's node, in either order", "[glue]") {
  const std::vector<GluePart> parts{
      block("a", {1, 1, 1}, Vec3(0, 0, 0)), block("b", {1, 1, 1}, Vec3(1, 0, 0)),
      block("c", {1, 1, 1}, Vec3(0, 1, 0)), block("d", {1, 1, 1}, Vec3(1, 1, 0))};
  const std::vector<GlueSettings> chain{gluing(0, 1, 0.1), gluing(1, 3, 0.1), gluing(0, 2, 0.1),
                                        gluing(2, 3, 0.1)};
  for (const bool backwards : {false, true}) {
    auto glues = chain;
    if (backwards) std::reverse(glues.begin(), glues.end());
    const auto result = glued(parts, glues);
    CHECK(result.nodeCount == 3 * 3 * 2);  // one 2 x 2 x 1 block
    std::set<NodeIndex> atMiddle;
    for (std::size_t p = 0; p < 4; ++p)
      for (std::size_t node = 0; node < 8; ++node)
        if ((parts[p].nodes[node] - Vec3(1, 1, 0)).norm() < 1e-9) atMiddle.insert(result.globalNode[p][node]);
    CHECK(atMiddle.size() == 1);
  }
}

TEST_CASE("A node dropped by one gluing is left alone by the next", "[glue]") {
  const std::vector<GluePart> parts{block("a", {1, 1, 1}, Vec3(0, 0, 1)),
                                    block("b", {1, 1, 1}, Vec3(0, 0, 0)),
                                    block("c", {1, 1, 1}, Vec3(1, 0, 1))};
  const auto result = glued(parts, {gluing(0, 1, 0.1), gluing(0, 2, 0.1)});
  CHECK(result.reports[0].nodesMerged == 4);
  CHECK(result.reports[1].nodesMerged == 2);
  CHECK(result.reports[1].nodesTaken == 2);
}

TEST_CASE("Nodes share a partner only where there is no other nearly as near", "[glue]") {
  GluePart a = unshaped("a"), b = unshaped("b");
  a.nodes = {Vec3(0.0, 0, 0), Vec3(0.1, 0, 0), Vec3(0.2, 0, 0)};
  const auto partners = [&](double reach, double other) {
    b.nodes = {Vec3(0.12, 0, 0), Vec3(other, 0, 0)};
    const auto preview = previewGlue(a, b, gluing(0, 1, reach));
    REQUIRE(preview.ok());
    std::vector<NodeIndex> found;
    for (const auto& pair : preview->pairs) found.push_back(pair.b);
    return found;
  };
  CHECK(partners(0.15, 0.31) == std::vector<NodeIndex>{0, 0, 1});  // 0.11 instead of 0.08
  CHECK(partners(0.15, 0.33) == std::vector<NodeIndex>{0, 0, 0});  // 0.13 is too far for that
  CHECK(partners(0.10, 0.31) == std::vector<NodeIndex>{0, 0});     // out of reach, as is the first node
}

TEST_CASE("A cell whose corners fall together is a wedge where it keeps a volume", "[glue]") {
  // a is twice as fine as b across the face: nine nodes find four.
  const std::vector<GluePart> parts{block("a", {2, 2, 2}, Vec3(0, 0, 1), 0.5),
                                    block("b", {1, 1, 1}, Vec3(0, 0, 0))};
  const auto result = glued(parts, {gluing(0, 1, 0.49)});
  CHECK(result.reports[0].nodesMerged == 4);
  CHECK(result.reports[0].wedges == 0);
  const auto wider = glued(parts, {gluing(0, 1, 0.6)});
  CHECK(wider.reports[0].wedges > 0);
  CHECK(wider.reports[0].wedges <= wider.misshapen[0].size());
  CHECK(wider.reports[0].wedges + wider.reports[0].cellsDropped == 4);
  const std::vector<Vec3> positions = positionsOf(parts, wider);
  double volume = 0.0;
  for (sim::CellIndex cell = 0; cell < parts[0].cells.size(); ++cell) {
    sim::CellCorners corners;
    for (std::size_t c = 0; c < 8; ++c) corners[c] = wider.globalNode[0][parts[0].cells[cell][c]];
    const bool isMisshapen = std::binary_search(wider.misshapen[0].begin(), wider.misshapen[0].end(), cell);
    const bool isDropped =
        std::binary_search(wider.droppedCells[0].begin(), wider.droppedCells[0].end(), cell);
    if (sim::isWedge(corners)) CHECK((isMisshapen || isDropped));
    if (!isDropped) CHECK(sim::isProperWedge(corners));
    if (!isDropped) volume += modeling::cellVolume(modeling::cornerPositions(positions, corners));
  }
  // Without the wedges it is 5/8 of a's cube.
  CHECK(volume > 0.8);
}

TEST_CASE("Whatever the reach and the mismatch, no cell is left twisted", "[glue]") {
  std::mt19937_64 random(5);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int trial = 0; trial < 60; ++trial) {
    const std::vector<GluePart> parts{
        block("a", {3, 4, 3}, Vec3(uniform(0, 1), uniform(0, 1), uniform(2, 3.2)), uniform(0.4, 1.5)),
        block("b", {4, 4, 3}, Vec3(0, 0, 0))};
    const auto result = glue(parts, {gluing(0, 1, uniform(0.3, 1.5))});
    INFO("trial " << trial << ": " << (result.ok() ? "" : result.problem().line()));
    if (!result.ok()) {
      CHECK(result.problem().what.find("no node") != std::string::npos);
      continue;
    }
    CHECK(worstOf(parts, *result) >= modeling::kBentIn);
  }
}

TEST_CASE("A part glued on minds the cells of what is glued to it", "[glue]") {
  // The halves share their inner edge; then one is pulled to b, and with it the other's cells.
  for (const double reach : {0.3, 0.5, 0.8, 1.2}) {
    std::vector<GluePart> parts;
    const auto add = [&](const char* name, const auto& shape) {
      const auto lattice = build(shape);
      REQUIRE(lattice.ok());
      parts.push_back(unshaped(name));
      parts.back().nodes = lattice->nodes;
      parts.back().cells = lattice->cells;
    };
    add("body", tests::teapotBody(0.5));
    add("upper handle", tests::teapotHandleHalf(true, 0.5));
    add("lower handle", tests::teapotHandleHalf(false, 0.5));
    add("left spout", tests::teapotSpoutHalf(true, 0.5));
    add("right spout", tests::teapotSpoutHalf(false, 0.5));
    const auto result = glued(parts, {gluing(1, 2, 0.01), gluing(3, 4, 0.01), gluing(1, 0, reach),
                                      gluing(2, 0, reach), gluing(3, 0, reach), gluing(4, 0, reach)});
    for (const auto& report : result.reports) CHECK(report.nodesMerged > 10);
    CHECK(worstOf(parts, result) >= modeling::kBentIn);
  }
}

TEST_CASE("Which nodes are glued can be said", "[glue]") {
  const GluePart a = block("a", {2, 2, 2}, Vec3(0, 0, 2)), b = block("b", {2, 2, 2}, Vec3(0, 0, 0));
  GlueSettings settings = gluing(0, 1, 0.5);
  SECTION("by leaving some out") {
    const auto all = previewGlue(a, b, settings);
    settings.excludedNodes = {all->pairs[0].a, all->pairs[4].a};
    CHECK(previewGlue(a, b, settings)->pairs.size() == 7);
  }
  SECTION("by naming pairs, whatever the reach") {
    settings.reach = 0.0;
    settings.explicitPairs = {{8, 2, 0.0}, {0, 1, 0.0}};
    const auto preview = previewGlue(a, b, settings);
    REQUIRE(preview.ok());
    REQUIRE(preview->pairs.size() == 2);
    CHECK(preview->pairs[0].a == 0);
    CHECK(preview->pairs[0].b == 1);
    CHECK(preview->pairs[0].distance == Approx((a.nodes[0] - b.nodes[1]).norm()));
  }
}

TEST_CASE("Loose bonds are glued too", "[glue]") {
  GluePart a = unshaped("a"), b = unshaped("b");
  a.nodes = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.5, 3, 0)};
  a.looseBonds = {{0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}};
  b.nodes = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 3, 0)};
  b.looseBonds = {{0, 1}, {0, 2}};
  GlueSettings settings = gluing(0, 1, 0.1);
  settings.excludedNodes = {3};
  const auto result = glued({a, b}, {settings});
  CHECK(result.nodeCount == 5);
  CHECK(result.reports[0].bondsZeroed == 1);
  CHECK(result.reports[0].bondsDuplicate == 0);

  // Glued by two gluings, a bond is not zero; it falls on b's own.
  GluePart c = unshaped("c");
  c.nodes = {Vec3(1, 0, 0), Vec3(9, 9, 9)};
  GlueSettings first = gluing(0, 1, 0.1), second = gluing(0, 2, 0.1);
  first.excludedNodes = {1, 2, 3};
  const auto twice = glued({a, b, c}, {first, second, gluing(2, 1, 0.1)});
  CHECK(twice.reports[0].bondsZeroed == 0);
  CHECK(twice.reports[1].bondsDuplicate == 1);
}

TEST_CASE("Gluings that cannot be are problems with a place and a remedy", "[glue]") {
  const std::vector<GluePart> parts{block("a", {2, 2, 2}, Vec3(0, 0, 2.3)),
                                    block("b", {2, 2, 2}, Vec3(0, 0, 0)),
                                    block("c", {2, 2, 2}, Vec3(2, 0, 2.3))};
  const auto problemOf = [&](const std::vector<GlueSettings>& glues) {
    const auto result = glue(parts, glues);
    REQUIRE_FALSE(result.ok());
    CHECK_FALSE(result.problem().remedy.empty());
    std::string text = result.problem().place;
    text += ": ";
    text += result.problem().what;
    return text;
  };
  GlueSettings twoPartners = gluing(0, 1, 1), stranger = twoPartners, moved = gluing(0, 2, 1);
  twoPartners.explicitPairs = {{0, 0, 0}, {0, 1, 0}};
  stranger.explicitPairs = {{0, 27, 0}};
  CHECK(problemOf({gluing(0, 1, 0.2)}) ==
        "glue[0]: no node of 'a' is within 0.2 cm of 'b', the nearest is 0.3 cm away");
  CHECK(problemOf({gluing(0, 1, 0.4), gluing(1, 0, 0.4)}) ==
        "glue[1]: 'b' and 'a' are glued already by glue[0]");
  CHECK(problemOf({gluing(1, 1, 0.4)}) == "glue[0]: 'b' would be glued to itself");
  CHECK(problemOf({gluing(0, 3, 0.4)}) == "glue[0]: a part to glue does not exist");
  CHECK(problemOf({gluing(0, 1, 0.0)}) ==
        "glue[0].reach: the reach must be a positive number of centimetres");
  CHECK(problemOf({gluing(0, 1, std::nan(""))}) ==
        "glue[0].reach: the reach must be a positive number of centimetres");
  CHECK(problemOf({twoPartners}) == "glue[0]: node 0 of 'a' is in two pairs");
  CHECK(problemOf({stranger}) == "glue[0]: a pair names a node that does not exist");
  // Node 0 of a lies over b's corner; c's node 0 is another node.
  moved.explicitPairs = {{0, 0, 0}};
  CHECK(problemOf({gluing(0, 1, 0.4), moved}) ==
        "glue[1]: node 0 of 'a' was glued to another node by glue[0]");
}

TEST_CASE("A cell that gluing would turn inside out is refused", "[glue]") {
  const std::vector<GluePart> parts{block("a", {1, 1, 1}, Vec3(0, 0, 0)),
                                    block("b", {1, 1, 1}, Vec3(0, 0, 3))};
  GlueSettings settings = gluing(0, 1, 1.0);
  for (NodeIndex node = 0; node < 8; ++node)
    if (parts[0].nodes[node].z() == 0.0) {  // a's floor is pulled through its ceiling
      NodeIndex above = 0;
      while ((parts[1].nodes[above] - parts[0].nodes[node]).head<2>().norm() > 0.1) ++above;
      settings.explicitPairs.push_back({node, above, 0.0});
    }
  const auto result = glue(parts, {settings});
  REQUIRE_FALSE(result.ok());
  CHECK(result.problem().place == "glue[0]");
  CHECK(result.problem().what.find("inside out") != std::string::npos);
}

TEST_CASE("Nearest points are found, as a search of all finds them", "[glue]") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> at(0.0, 1.0);
  const auto point = [&] { return Vec3(at(random), at(random), 0.2 * at(random)); };
  std::vector<Vec3> points(500);
  for (Vec3& p : points) p = point();
  points[77] = points[33];  // ties go to the lower index
  modeling::NearestPoints index(points);
  std::vector<bool> taken(points.size(), false);
  for (int trial = 0; trial < 300; ++trial) {
    const Vec3 place = trial == 0 ? points[33] : point();
    const double reach = 0.02 + 0.2 * at(random);
    NodeIndex best = sim::kNone, bestFree = sim::kNone;
    for (NodeIndex i = 0; i < points.size(); ++i) {
      const double distance = (points[i] - place).norm();
      if (distance > reach) continue;
      if (best == sim::kNone || distance < (points[best] - place).norm()) best = i;
      if (!taken[i] && (bestFree == sim::kNone || distance < (points[bestFree] - place).norm())) bestFree = i;
    }
    const auto found = index.nearest(place, reach), free = index.nearestFree(place, reach);
    CHECK((found ? found->point : sim::kNone) == best);
    CHECK((free ? free->point : sim::kNone) == bestFree);
    if (bestFree != sim::kNone) {
      index.take(bestFree);
      taken[bestFree] = true;
    }
  }
}

TEST_CASE("The cost of gluing grows with the nodes, not with their square", "[glue]") {
  // Processor time, and a ratio of it: true on a busy machine and under sanitizers too. 8 times the nodes
  // cost 8 times the time and a little for sorting; trying every pair would cost 64 times.
  const auto cost = [](int cells) {
    const double side = cells;
    const std::vector<GluePart> parts{block("a", {cells, cells, cells}, Vec3(0.02, 0.03, side + 0.1)),
                                      block("b", {cells, cells, cells}, Vec3(0, 0, 0))};
    double least = 1e9;
    for (int trial = 0; trial < 2; ++trial) {
      const std::clock_t start = std::clock();
      const auto result = glued(parts, {gluing(0, 1, 0.4)});
      least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
      CHECK(result.reports[0].nodesMerged == static_cast<std::size_t>((cells + 1) * (cells + 1)));
    }
    return least;
  };
  CHECK(cost(40) < 24.0 * cost(20));
}
