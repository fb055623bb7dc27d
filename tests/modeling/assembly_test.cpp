#include "modeling/assembly/assembly.h"

#include <cmath>
#include <map>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "tests/support/elastic_body.h"

using namespace modeling;
using tests::Block;

namespace {

AssemblyPart partOf(Lattice lattice, const Vec3& shift = Vec3::Zero()) {
  AssemblyPart part;
  part.name = "part";
  part.lattice = std::move(lattice);
  for (Vec3& node : part.lattice.nodes) node += shift;
  return part;
}

double massOf(const sim::Blueprint& blueprint) {
  double mass = 0.0;
  for (const auto& node : blueprint.nodes) mass += node.mass;
  return mass;
}

sim::Blueprint assembled(const std::vector<AssemblyPart>& parts, const GlueResult& glue,
                         const Material& material = tests::plainMaterial()) {
  auto blueprint = assemble(parts, {material}, glue);
  REQUIRE(blueprint);
  // What the simulation checks of a network holds of every one that is assembled.
  auto network = sim::buildNetwork(*blueprint, 1);
  if (!network) FAIL(network.problem().line());
  return std::move(blueprint).value();
}

/// Two blocks of 2 x 2 x 2 cells, the second (a) standing on the first's (b) face x = 2, glued there by the
/// first gluing: its nodes of i = 0 are the first's of i = 2.
struct GluedBlocks {
  Block block{{2, 2, 2}, 1.0};
  std::vector<AssemblyPart> parts{partOf(block.lattice()), partOf(block.lattice(), Vec3(2.0, 0.0, 0.0))};
  GlueResult glue = tests::unglued(parts);

  GluedBlocks() {
    const std::size_t face = 9;
    for (std::size_t i = 0; i < block.nodeCount(); ++i) {
      const bool glued = i < face;
      glue.globalNode[1][i] = static_cast<sim::NodeIndex>(i + block.nodeCount() - face);
      if (glued) glue.gluedBy[1][i] = 0;
    }
    glue.nodeCount = 2 * block.nodeCount() - face;
  }
};

}  // namespace

TEST_CASE("a body weighs its density times its volume, however its cells are distorted") {
  const Block block{{3, 4, 5}, 0.7};
  for (const double amount : {0.0, 0.1, 0.25}) {
    const auto blueprint =
        assembled({partOf(block.shaken(amount, 3))}, tests::unglued({partOf(block.lattice())}));
    CHECK(massOf(blueprint) == Approx(2.0 * block.size().prod()).epsilon(1e-13));
  }
}

TEST_CASE("bonds are as long as their nodes are apart, and damped in proportion to their stiffness") {
  Material material = tests::plainMaterial();
  const Block block{{3, 3, 3}, 0.5};
  const auto part = partOf(block.shaken(0.2, 4));
  const auto blueprint = assembled({part}, tests::unglued({part}), material);
  for (const auto& bond : blueprint.bonds) {
    CHECK(bond.restLength == (blueprint.nodes[bond.b].position - blueprint.nodes[bond.a].position).norm());
    CHECK(bond.damping == Approx(dampingTime(material, 0.5) * bond.stiffness).epsilon(1e-12));
  }
}

TEST_CASE("gluing two blocks gives one, but for bonds within the glued face, which only one of them gives") {
  const GluedBlocks glued;
  const auto joined = assembled(glued.parts, glued.glue);
  const auto whole = assembled({partOf(Block{{4, 2, 2}, 1.0}.lattice())},
                               tests::unglued({partOf(Block{{4, 2, 2}, 1.0}.lattice())}));
  REQUIRE(joined.nodes.size() == whole.nodes.size());
  REQUIRE(joined.bonds.size() == whole.bonds.size());
  CHECK(joined.cells == whole.cells);
  int halved = 0;
  for (std::size_t i = 0; i < whole.bonds.size(); ++i) {
    const auto& bond = whole.bonds[i];
    const bool within = whole.nodes[bond.a].position.x() == 2.0 && whole.nodes[bond.b].position.x() == 2.0;
    halved += within;
    CHECK(joined.bonds[i].a == bond.a);
    CHECK(joined.bonds[i].b == bond.b);
    CHECK(joined.bonds[i].stiffness == Approx((within ? 0.5 : 1.0) * bond.stiffness).epsilon(1e-9));
    CHECK(joined.bonds[i].restLength == Approx(bond.restLength).epsilon(1e-12));
  }
  CHECK(halved == 12 + 8);
  for (std::size_t i = 0; i < whole.nodes.size(); ++i)
    CHECK(joined.nodes[i].mass == Approx(whole.nodes[i].mass).epsilon(1e-12));
}

TEST_CASE("what glue() finds in two touching blocks is what was glued by hand") {
  const GluedBlocks byHand;
  std::vector<GluePart> parts;
  for (const auto& part : byHand.parts)
    parts.push_back({part.name, part.lattice.nodes, part.lattice.cells, {}});
  GlueSettings settings;
  settings.a = 1;
  settings.b = 0;
  settings.reach = 0.1;
  const auto found = glue(parts, {settings});
  REQUIRE(found);
  const auto joined = assembled(byHand.parts, *found);
  const auto expected = assembled(byHand.parts, byHand.glue);
  REQUIRE(joined.bonds.size() == expected.bonds.size());
  for (std::size_t i = 0; i < expected.bonds.size(); ++i)
    CHECK(joined.bonds[i].stiffness == expected.bonds[i].stiffness);
  CHECK(massOf(joined) == Approx(2.0 * 16.0).epsilon(1e-13));
}

TEST_CASE("a merged node belongs to the part it was merged into") {
  GluedBlocks glued;
  glued.parts[1].velocity = Vec3(0.0, 0.0, 5.0);
  glued.parts[1].lattice.nodes[0].y() +=
      0.2;  // dropped by the gluing, so that it doesn't matter where it was
  const auto joined = assembled(glued.parts, glued.glue);
  CHECK(joined.nodes[18].position == glued.parts[0].lattice.nodes[18]);
  CHECK(joined.nodes[18].velocity == Vec3::Zero());
  CHECK(joined.nodes[18].part == 0);
  CHECK(joined.nodes[27].velocity == Vec3(0.0, 0.0, 5.0));
  CHECK(joined.nodes[27].part == 1);
}

TEST_CASE("bonds between nodes merged by different gluings stay, and add to what is there") {
  GluedBlocks glued;
  for (std::size_t i = 0; i < 9; i += 2)
    glued.glue.gluedBy[1][i] = 1;  // centre and corners by another gluing
  const auto joined = assembled(glued.parts, glued.glue);
  const GluedBlocks plain;
  const auto once = assembled(plain.parts, plain.glue);
  REQUIRE(joined.bonds.size() == once.bonds.size());
  for (std::size_t i = 0; i < once.bonds.size(); ++i) {
    const bool edgeWithin = once.bonds[i].a >= 18 && once.bonds[i].b < 27 && once.bonds[i].restLength < 1.2;
    CHECK(joined.bonds[i].stiffness ==
          Approx((edgeWithin ? 2.0 : 1.0) * once.bonds[i].stiffness).epsilon(1e-9));
  }
}

TEST_CASE("a dropped cell leaves its bonds but is no cell") {
  GluedBlocks glued;
  // The second layer's corner node falls onto the glued face: that cell becomes a wedge.
  glued.glue.globalNode[1][9] = glued.glue.globalNode[1][0];
  for (std::size_t i = 10; i < 27; ++i) --glued.glue.globalNode[1][i];
  --glued.glue.nodeCount;
  glued.glue.gluedBy[1][9] = 0;
  glued.glue.droppedCells[1] = {0};
  auto blueprint = assemble(glued.parts, {tests::plainMaterial()}, glued.glue);
  // Its neighbour along x shares node 9 and is pulled along, still with all eight corners.
  REQUIRE(blueprint);
  CHECK(blueprint->cells.size() == 15);
  CHECK(sim::buildNetwork(*blueprint, 1).ok());
  bool kept = false;
  const auto across = glued.glue.globalNode[1][10];
  for (const auto& bond : blueprint->bonds) {
    CHECK(bond.a != bond.b);
    kept = kept || (bond.a == glued.glue.globalNode[1][0] && bond.b == across);
  }
  CHECK(kept);

  // As a wedge it has the same bonds and masses, and is a cell.
  glued.glue.droppedCells[1].clear();
  glued.glue.misshapen[1] = {0};
  const auto wedge = assemble(glued.parts, {tests::plainMaterial()}, glued.glue);
  REQUIRE(wedge);
  CHECK(wedge->cells.size() == 16);
  CHECK(wedge->bonds.size() == blueprint->bonds.size());
  for (std::size_t i = 0; i < wedge->nodes.size(); ++i)
    CHECK(wedge->nodes[i].mass == blueprint->nodes[i].mass);
  CHECK(sim::buildNetwork(*wedge, 1).ok());
}

TEST_CASE("held nodes have infinite mass") {
  auto part = partOf(Block{{1, 1, 1}, 1.0}.lattice());
  part.held.assign(8, 0);
  part.held[3] = 1;
  const auto blueprint = assembled({part}, tests::unglued({part}));
  for (std::size_t i = 0; i < 8; ++i) CHECK(std::isinf(blueprint.nodes[i].mass) == (i == 3));
}

TEST_CASE("a raw network keeps its own bonds, masses and velocities") {
  AssemblyPart part;
  part.name = "chain";
  part.lattice.nodes = {Vec3::Zero(), Vec3(1.0, 0.0, 0.0), Vec3(2.0, 0.0, 0.0)};
  part.looseBonds = {{2, 1, 50.0, 0.9, 0.1, 1}, {0, 1, 70.0, 1.0, 0.2, 0}};
  part.looseMasses = {1.0, 2.0, 3.0};
  part.looseVelocities = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()};
  part.velocity = Vec3::UnitZ();
  Material breaking = tests::plainMaterial();
  breaking.threshold = {0.05, 0.0};
  const auto blueprint = assemble({part}, {tests::plainMaterial(), breaking}, tests::unglued({part}));
  REQUIRE(blueprint);
  REQUIRE(blueprint->bonds.size() == 2);
  CHECK(blueprint->bonds[0].stiffness == 70.0);
  CHECK(blueprint->bonds[1].a == 1);
  CHECK(blueprint->bonds[1].b == 2);
  CHECK(blueprint->bonds[1].restLength == 0.9);
  CHECK(blueprint->bonds[1].damping == 0.1);
  CHECK(blueprint->materials[blueprint->bonds[1].material].thresholdMean == 0.05);
  CHECK(blueprint->nodes[2].mass == 3.0);
  CHECK(blueprint->nodes[1].velocity == Vec3(1.0, 0.0, 1.0));
}

TEST_CASE("a raw network with two bonds on one pair is refused") {
  AssemblyPart part;
  part.lattice.nodes = {Vec3::Zero(), Vec3::UnitX()};
  part.looseBonds = {{0, 1, 1.0, 1.0, 0.0, 0}, {1, 0, 1.0, 1.0, 0.0, 0}};
  part.looseMasses = {1.0, 1.0};
  const auto blueprint = assemble({part}, {tests::plainMaterial()}, tests::unglued({part}));
  REQUIRE_FALSE(blueprint);
  CHECK(blueprint.problem().place == "parts[0]");
}

TEST_CASE("parts of one tough material but different cells break at different strains") {
  Material tough = tests::plainMaterial();
  tough.fractureToughness = 1.0;
  const auto coarse = partOf(Block{{1, 1, 1}, 1.0}.lattice());
  const auto fine = partOf(Block{{1, 1, 1}, 0.25}.lattice(), Vec3(5.0, 0.0, 0.0));
  const auto blueprint = assembled({coarse, fine, coarse}, tests::unglued({coarse, fine, coarse}), tough);
  REQUIRE(blueprint.materials.size() == 2);
  CHECK(blueprint.materials[1].name == blueprint.materials[0].name);
  CHECK(blueprint.materials[1].thresholdMean == Approx(2.0 * blueprint.materials[0].thresholdMean));
  CHECK(blueprint.nodes[0].material == 0);
  CHECK(blueprint.nodes[8].material == 1);
  CHECK(blueprint.nodes[16].material == 0);
}

TEST_CASE("a cell turned inside out is refused with its part and number") {
  const auto fine = partOf(Block{{1, 1, 1}, 1.0}.lattice());
  auto inverted = fine;
  for (Vec3& node : inverted.lattice.nodes) node.x() = -node.x();
  const auto blueprint =
      assemble({fine, inverted}, {tests::plainMaterial()}, tests::unglued({fine, inverted}));
  REQUIRE_FALSE(blueprint);
  CHECK(blueprint.problem().place == "parts[1]");
  CHECK(blueprint.problem().what.find("cell 0") != std::string::npos);
}
