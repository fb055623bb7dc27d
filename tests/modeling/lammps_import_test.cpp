#include "modeling/exchange/lammps_import.h"

#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>

#include "modeling/exchange/export.h"
#include "modeling/exchange/lammps_dump.h"
#include "tests/fuzz/text_cuts.h"
#include "tests/sim/take_sample.h"
#include "tests/support/flying_pieces.h"
#include "tests/support/grid_network.h"

namespace {

/// Two moments of the eight nodes of a cell, as LAMMPS writes them, in no order.
std::string dumpOfCell() {
  const sim::Network network = tests::gridNetwork(1, 1, 1);
  std::ostringstream text;
  text.precision(17);
  for (int moment = 0; moment < 2; ++moment) {
    text << "ITEM: TIME\n"
         << 0.25 * moment << "\nITEM: TIMESTEP\n"
         << 10 * moment << "\nITEM: NUMBER OF ATOMS\n8\nITEM: BOX BOUNDS mm mm mm\n0 1\n0 1\n0 1\n"
         << "ITEM: ATOMS id x y z vx vy vz\n";
    for (std::size_t node = 8; node-- > 0;) {
      text << node + 1 << " " << (network.positions[node] + sim::Vec3(0.1, 0.2, 0.3) * moment).transpose()
           << " 1 2 3\n";
    }
  }
  return text.str();
}

/// All bonds, and later all but those of the first node.
std::string bondsOfCell(const sim::Network& network) {
  std::ostringstream text;
  for (int moment = 0; moment < 2; ++moment) {
    std::ostringstream rows;
    int count = 0;
    for (sim::NodeIndex a = moment == 0 ? 0 : 1; a < 8; ++a) {
      for (sim::BondIndex bond = network.firstBond[a]; bond < network.firstBond[a + 1]; ++bond, ++count)
        rows << network.bondEnds[bond] + 1 << " " << a + 1 << "\n";
    }
    text << "ITEM: TIMESTEP\n"
         << 10 * moment << "\nITEM: NUMBER OF ENTRIES\n"
         << count << "\nITEM: BOX BOUNDS mm mm mm\n0 1\n0 1\n0 1\nITEM: ENTRIES c_pairs[1] c_pairs[2] \n"
         << rows.str();
  }
  return text.str();
}

struct Import {
  tests::ScratchFolder scratch;
  sim::Network network = tests::gridNetwork(1, 1, 1);

  sim::Result<std::size_t> run(const std::string& dump, const std::string& bonds) const {
    std::ofstream(scratch.file("run.dump"), std::ios::binary) << dump;
    if (!bonds.empty()) std::ofstream(scratch.file("run.bonds"), std::ios::binary) << bonds;
    return modeling::importLammps(
        {scratch.file("run.dump"), bonds.empty() ? "" : scratch.file("run.bonds"), {}}, {}, network,
        scratch.file("run.take"));
  }
};

TEST_CASE("a dump of LAMMPS becomes a take: nodes where they were, what is gone broken, and fragments") {
  const Import import;
  const auto frames = import.run(dumpOfCell(), bondsOfCell(import.network));
  REQUIRE(frames.ok());
  CHECK(*frames == 2);
  const auto take = *sim::TakeReader::open(import.scratch.file("run.take"));
  CHECK(take->frameTime(1) == 0.25);
  const sim::SnapshotPointer moment = *take->frame(1);
  const sim::Snapshot& last = *moment;
  for (std::size_t node = 0; node < 8; ++node) {
    CHECK((last.positions[node] - import.network.positions[node] - sim::Vec3(0.1, 0.2, 0.3)).norm() < 1e-15);
    CHECK(last.velocities[node] == sim::Vec3(1.0, 2.0, 3.0));
  }
  CHECK(last.broken->cells == std::vector<std::uint8_t>{1});
  CHECK(take->events()->size() == 3);
  const std::vector<sim::Fragment>& fragments = last.broken->fragments;
  REQUIRE(fragments.size() == 2);
  CHECK(fragments[0].nodeCount + fragments[1].nodeCount == 8);
  CHECK(fragments[1].born == 0.25);
  CHECK(last.ledger.energy.kinetic == Approx(0.5 * 8.0 * 14.0));
}

TEST_CASE("a dump of another scene, of no times or of other columns is told from where it differs") {
  const Import import;
  const auto lineOf = [&](std::string dump, const std::string& from, const std::string& to) {
    dump.replace(dump.rfind(from), from.size(), to);
    const auto frames = import.run(dump, "");
    REQUIRE_FALSE(frames.ok());
    return frames.problem().line();
  };
  CHECK_THAT(lineOf(dumpOfCell(), "OF ATOMS\n8", "OF ATOMS\n7"), Catch::Contains("the scene has 8"));
  CHECK_THAT(lineOf(dumpOfCell(), "id x y z", "id x y q"), Catch::Contains("vx, vy and vz are needed"));
  CHECK_THAT(lineOf(dumpOfCell(), "ITEM: TIME\n0.25\n", ""), Catch::Contains("dump_modify"));
  CHECK_THAT(lineOf(dumpOfCell(), "\n8 ", "\n9 "), Catch::Contains("run.dump:31:1"));
  CHECK_THAT(lineOf(dumpOfCell(), "OF ATOMS\n8", "OF ATOMS\n8000000000"), Catch::Contains("more than"));
}

TEST_CASE("a damaged dump is a problem with a place, never a crash") {
  const Import import;
  const std::string bonds = bondsOfCell(import.network);
  std::size_t problems = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const auto frames = seed % 2 == 0 ? import.run(tests::damaged(dumpOfCell(), seed), bonds)
                                      : import.run(dumpOfCell(), tests::damaged(bonds, seed));
    if (frames.ok()) continue;
    ++problems;
    CHECK_THAT(frames.problem().place, Catch::Contains("run."));
  }
  CHECK(problems > 50);
}

TEST_CASE("a line without end is refused before it fills the memory") {
  const Import import;
  const auto frames = import.run("ITEM: TIMESTEP\n" + std::string(100000, '1'), "");
  REQUIRE_FALSE(frames.ok());
  CHECK_THAT(frames.problem().line(), Catch::Contains("too long"));
}

TEST_CASE("an input for LAMMPS says what it does otherwise, and names that it would take apart are refused") {
  const tests::MemoryTake take = tests::flyingPieces(2, 1);
  const tests::ScratchFolder scratch;
  std::vector<std::string> remarks;
  const auto note = [&](const std::string& text) { remarks.push_back(text); };
  REQUIRE(modeling::writeLammps(take, {.path = scratch.file("run"), .progress = {}, .remark = note}).ok());
  std::ifstream stream(scratch.file("run.in"));
  const std::string input(std::istreambuf_iterator<char>(stream), {});
  REQUIRE_FALSE(remarks.empty());
  for (const std::string& remark : remarks) CHECK_THAT(input, Catch::Contains("# - " + remark));
  CHECK_FALSE(modeling::writeLammps(take, {.path = scratch.file("my run"), .progress = {}}).ok());
}

}  // namespace
