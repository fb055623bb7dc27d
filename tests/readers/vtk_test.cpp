#include <fstream>

#include <catch2/catch.hpp>

#include "modeling/exchange/export.h"
#include "tests/support/flying_pieces.h"
#include "tests/support/run_program.h"

/// What VTK's own reader, which is ParaView's, makes of our files, where it is installed.
namespace {

using sim::Vec3;

/// Debian's Python has the packages of Debian; another one may come first in the path.
const char* const kPython = "/usr/bin/python3";

TEST_CASE("VTK reads the nodes, bonds and strains of a frame") {
  if (tests::runCommand(std::string(kPython) + " -c 'import vtkmodules.vtkIOXML'").status != 0) {
    WARN("python3-vtk9 is not installed: what VTK makes of our files was not tested");
    return;
  }
  const tests::MemoryTake take = tests::flyingPieces(3, 3);
  const std::string folder = tests::freshFolder("smithereens-vtk");
  REQUIRE(modeling::writeVtk(take, {.path = folder + "/p.pvd", .lastFrame = 2, .progress = {}}).ok());
  const std::string out = folder + "/out.txt";
  const auto answer =
      tests::runCommand(std::string(kPython) + " \"" SMITHEREENS_SOURCE_DIR "/tests/readers/read_vtk.py\" " +
                        folder + "/p.0002.vtu " + out);
  INFO(answer.errors);
  REQUIRE(answer.status == 0);
  const sim::Snapshot& frame = **take.frame(2);
  const sim::Network& network = take.network();
  std::ifstream stream(out);
  std::string kind;
  for (std::size_t node = 0; node < network.nodeCount(); ++node) {
    Vec3 position, velocity;
    sim::FragmentId fragment = sim::kNone;
    stream >> kind >> position.x() >> position.y() >> position.z();
    stream >> velocity.x() >> velocity.y() >> velocity.z() >> fragment;
    REQUIRE(kind == "point");
    CHECK(position == frame.positions[node]);
    CHECK(velocity == frame.velocities[node]);
    CHECK(fragment == frame.broken->fragmentOfNode[node]);
  }
  for (sim::BondIndex bond = 0; bond < network.bondCount(); ++bond) {
    sim::NodeIndex a = 0, b = 0;
    double strain = 0.0;
    int broken = -1;
    stream >> kind >> a >> b >> strain >> broken;
    REQUIRE(kind == "bond");
    CHECK(a == network.bondStart(bond));
    CHECK(b == network.bondEnds[bond]);
    CHECK(broken == int{frame.broken->bonds[bond]});
    const double length = (frame.positions[a] - frame.positions[b]).norm();
    CHECK(strain == Approx(length / network.bond(bond).restLength - 1.0).margin(1e-12));
  }
  CHECK(static_cast<bool>(stream));
}

}  // namespace
