#include "modeling/import/lammps_data.h"

#include <catch2/catch.hpp>

namespace {

using modeling::parseLammpsData;

/// Ids out of order, to tell an id from a position in the file.
const std::string kPair = R"(a title

3 atoms
2 bonds
2 atom types
1 bond types
0 10 xlo xhi

Masses

1 2.5
2 4

Atoms # bond

30 1 1 0 0 0
10 1 2 1 0 0 0 0 0
20 1 1 1 1 0

Velocities

20 0 0 3
10 0 2 0
30 1 0 0

Bonds

1 1 30 10
2 1 20 10
)";

std::string changed(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST_CASE("nodes keep the order of the file's lines, whatever their ids") {
  const auto data = parseLammpsData(kPair, "pair.data");
  if (!data) FAIL(data.problem().line());
  CHECK(data->positions[1] == sim::Vec3(1, 0, 0));
  CHECK(data->masses == std::vector<double>{2.5, 4.0, 2.5});
  CHECK(data->velocities[0] == sim::Vec3(1, 0, 0));
  CHECK(data->velocities[2] == sim::Vec3(0, 0, 3));
  REQUIRE(data->bonds.size() == 2);
  CHECK(data->bonds[1].a == 2);
  CHECK(data->bonds[1].b == 1);
}

TEST_CASE("the file of the reference bar is read whole") {
  const auto data = modeling::loadLammpsData(SMITHEREENS_SOURCE_DIR "/tests/data/lammps-bar/caseA.data");
  if (!data) FAIL(data.problem().line());
  CHECK(data->positions.size() == 225);
  CHECK(data->bonds.size() == 1072);
  CHECK(data->positions[1].y() == 0.003108049841353322);
  CHECK(data->velocities.size() == 225);
}

struct Damage {
  const char* from;
  const char* to;
  const char* line;
};

TEST_CASE("what is wrong in a data file is told by line and column") {
  const Damage damages[] = {
      {"3 atoms", "4 atoms",
       "p:3:1: the header gives 4 for atoms, but there are 3; the file may be cut off; write it again"},
      {"3 atoms", "99999999999999999999 atoms", "p:3:1: \"99999999999999999999\" is no count"},
      {"2 bonds", "-2 bonds", "p:4:1: \"-2\" is no count; give a whole number of at least 0"},
      {"2 bonds\n", "", "p:1:1: the header gives no count for bonds, but there are 2"},
      {"1 1 0\n", "1 nan 0\n", "p:18:10: \"nan\" is no finite number; correct it"},
      {"1 1 0\n", "1 1e999 0\n", "p:18:10: \"1e999\" is no finite number; correct it"},
      {"1 1 0\n", "1 1\n", "p:18:1: this line has 5 words; write id molecule type x y z"},
      {"20 1 1", "10 1 1", "p:22:1: there is no atom 20"},
      {"30 10\n", "30 11\n", "p:28:8: there is no atom 11"},
      {"30 10\n", "30 30\n", "p:28:8: this bond joins a node to itself; name two nodes"},
      {"2 1 20 10", "2 1 10 30", "p:29:1: these two nodes are bonded already; keep one bond a pair"},
      {"2 1 20 10", "2 3 20 10", "p:29:1: the header has 1 bond types, this bond is of type 3"},
      {"# bond", "# full", "p:14:1: the atoms are of style \"full\"; write them with atom_style bond"},
      {"2 4\n", "2 -4\n", "p:12:3: the mass is \"-4\"; give a number above 0"},
      {"2 4\n", "", "p:16:1: atoms of type 2 have no mass"},
      {"0 0 0 0\n", "0 0 1 0\n", "p:17:16: this atom lies in another image of the box"},
      {"30 1 0 0\n", "", "p:28:1: there are 2 velocities; give one an atom"},
      {"Bonds", "Bends",
       "p:26:1: there is no section \"Bends\" in a file of nodes and bonds; did you mean \"Bonds\""},
      {"0 10 xlo", "5 angles\n0 10 xlo", "p:7:3: the file has angles"},
  };
  for (const Damage& damage : damages) {
    const auto data = parseLammpsData(changed(kPair, damage.from, damage.to), "p");
    INFO(damage.to);
    REQUIRE_FALSE(data.ok());
    INFO(data.problem().line());
    CHECK(data.problem().line().find(damage.line) == 0);
  }
  CHECK_FALSE(parseLammpsData("", "p").ok());
  CHECK_FALSE(parseLammpsData("title only", "p").ok());
  CHECK_FALSE(modeling::loadLammpsData("/nowhere.data").ok());
}

TEST_CASE("an id given twice is found whatever sections follow") {
  const auto data =
      parseLammpsData("t\n\n2 atoms\n\nMasses\n\n1 1\n\nAtoms\n\n7 1 1 0 0 0\n7 1 1 1 0 0\n", "p");
  REQUIRE_FALSE(data.ok());
  CHECK(data.problem().line() == "p:12:1: the id 7 is given twice; number atoms apart");
}

}  // namespace
