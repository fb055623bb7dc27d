#include "modeling/exchange/lammps_import.h"

#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>
#include <zlib.h>

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

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// Where all nodes of the cell are in each moment of what was read.
void checkCell(const Import& import, const std::string& dump) {
  const auto frames = import.run(dump, "");
  if (!frames) FAIL(frames.problem().line());
  const auto take = *sim::TakeReader::open(import.scratch.file("run.take"));
  REQUIRE(take->frameCount() == 2);
  for (std::size_t moment = 0; moment < 2; ++moment) {
    const sim::SnapshotPointer read = *take->frame(moment);
    const sim::Vec3 moved = sim::Vec3(0.1, 0.2, 0.3) * static_cast<double>(moment);
    for (std::size_t node = 0; node < 8; ++node) {
      CHECK((read->positions[node] - import.network.positions[node] - moved).norm() < 1e-12);
      CHECK((read->velocities[node] - sim::Vec3(1, 2, 3)).norm() < 1e-12);
    }
  }
}

/// Two moments of the cell, each row made by `row` of a node's place.
template <class Row>
std::string dumpBy(const std::string& box, const std::string& columns, const Row& row) {
  const sim::Network network = tests::gridNetwork(1, 1, 1);
  std::ostringstream text;
  text.precision(17);
  for (int moment = 0; moment < 2; ++moment) {
    text << "ITEM: TIMESTEP\n"
         << 10 * moment << "\nITEM: TIME\n"
         << 0.25 * moment << "\nITEM: NUMBER OF ATOMS\n8\nITEM: BOX BOUNDS " << box << "\nITEM: ATOMS "
         << columns << "\n";
    for (std::size_t node = 0; node < 8; ++node)
      text << row(node + 1, sim::Vec3(network.positions[node] + sim::Vec3(0.1, 0.2, 0.3) * moment)) << "\n";
  }
  return text.str();
}

std::string words(const sim::Vec3& numbers) {
  std::ostringstream text;
  text.precision(17);
  text << numbers.x() << " " << numbers.y() << " " << numbers.z();
  return text.str();
}

TEST_CASE("columns that are not needed are passed over, whatever they hold, and in whatever order") {
  const Import import;
  const auto more = [](std::size_t id, const sim::Vec3& at) {
    return "Si nan 1 2 3 4 5 6 7 8 9 10 3 2 1 " + words(at) + " clay " + std::to_string(id);
  };
  checkCell(import, dumpBy("mm mm mm\n0 1\n0 1\n0 1",
                           "element c_bad q1 q2 q3 q4 q5 q6 q7 q8 q9 q10 vz vy vx x y z typelabel id", more));
}

TEST_CASE("positions by the box, through its faces and by images are where they are meant to be") {
  const Import import;
  const Eigen::Vector3d edge(4.0, 5.0, 6.0);
  const auto id = [](std::size_t node) { return std::to_string(node) + " "; };
  const std::string box = "pp pp pp\n-1 3\n-1 4\n-1 5";
  const sim::Vec3 corner(-1, -1, -1);
  checkCell(import, dumpBy(box, "id xs ys zs vx vy vz", [&](std::size_t node, const sim::Vec3& at) {
              return id(node) + words((at - corner).cwiseQuotient(edge)) + " 1 2 3";
            }));
  checkCell(import, dumpBy(box, "id xu yu zu x y z vx vy vz", [&](std::size_t node, const sim::Vec3& at) {
              return id(node) + words(at) + " 9 9 9 1 2 3";
            }));
  // Each node a box too low along x, by its image or by being looked for near where it was.
  const sim::Vec3 low(4.0, 0, 0);
  checkCell(import, dumpBy(box, "id x y z vx vy vz ix iy iz", [&](std::size_t node, const sim::Vec3& at) {
              return id(node) + words(at - low) + " 1 2 3 1 0 0";
            }));
  checkCell(import, dumpBy(box, "id x y z vx vy vz", [&](std::size_t node, const sim::Vec3& at) {
              return id(node) + words(at - low) + " 1 2 3";
            }));
  // A box that leans by 2 along x, whose outer bounds are further.
  Eigen::Matrix3d edges = edge.asDiagonal();
  edges(0, 2) = 2.0;
  checkCell(import, dumpBy("xy xz yz pp pp pp\n-1 5 0\n-1 4 2\n-1 5 0", "id xsu ysu zsu vx vy vz",
                           [&](std::size_t node, const sim::Vec3& at) {
                             return id(node) + words(edges.inverse() * (at - corner)) + " 1 2 3";
                           }));
  const auto boxless = import.run(
      dumpBy("ff ff ff\n0 0\n0 0\n0 0", "id xs ys zs vx vy vz",
             [&](std::size_t node, const sim::Vec3& at) { return id(node) + words(at) + " 1 2 3"; }),
      "");
  REQUIRE_FALSE(boxless.ok());
  CHECK_THAT(boxless.problem().line(), Catch::Contains("does not state the box"));
}

TEST_CASE("units that a dump states are taken into ours") {
  const Import import;
  const auto metres = [](std::size_t node, const sim::Vec3& at) {
    return std::to_string(node) + " " + words(at / 100.0) + " 0.01 0.02 0.03";
  };
  const std::string text = dumpBy("mm mm mm\n0 1\n0 1\n0 1", "id x y z vx vy vz", metres);
  checkCell(import, "ITEM: UNITS\nsi\n" + text);
  CHECK_FALSE(import.run("ITEM: UNITS\nparsec\n" + text, "").ok());
  const auto halves = [](std::size_t node, const sim::Vec3& at) {
    return std::to_string(node) + " " + words(at * 2.0) + " 2 4 6 0.5";
  };
  checkCell(import, dumpBy("mm mm mm\n0 1\n0 1\n0 1", "id x y z vx vy vz v_cm", halves));
}

TEST_CASE("a dump that gzip packed is read, and a dump of another scene is not") {
  const Import import;
  const auto plain = [](std::size_t node, const sim::Vec3& at) {
    return std::to_string(node) + " " + words(at) + " 1 2 3";
  };
  const std::string text = dumpBy("mm mm mm\n0 1\n0 1\n0 1", "id x y z vx vy vz", plain);
  const gzFile packed = gzopen(import.scratch.file("packed.dump").c_str(), "wb");
  REQUIRE(gzwrite(packed, text.data(), static_cast<unsigned>(text.size())) > 0);
  gzclose(packed);
  std::ifstream stream(import.scratch.file("packed.dump"), std::ios::binary);
  checkCell(import, std::string(std::istreambuf_iterator<char>(stream), {}));
  const auto lineOf = [&](const std::string& dump) {
    const auto frames = import.run(dump, "");
    REQUIRE_FALSE(frames.ok());
    return frames.problem().line();
  };
  const auto elsewhere = [&](std::size_t node, const sim::Vec3& at) {
    return plain(node, at + sim::Vec3(0, 0, 7));
  };
  const auto larger = [&](std::size_t node, const sim::Vec3& at) { return plain(node, 20.0 * at); };
  const std::string box = "mm mm mm\n0 1\n0 1\n0 1";
  CHECK_THAT(lineOf(dumpBy(box, "id x y z vx vy vz", elsewhere)), Catch::Contains("another scene"));
  // From a later frame things may be anywhere, but whole bonds are not that long.
  const std::string later = replaced(dumpBy(box, "id x y z vx vy vz", larger), "TIMESTEP\n0", "TIMESTEP\n5");
  CHECK_THAT(lineOf(later), Catch::Contains("another scene"));
  CHECK(import.run(replaced(dumpBy(box, "id x y z vx vy vz", elsewhere), "TIMESTEP\n0", "TIMESTEP\n5"), "")
            .ok());
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
