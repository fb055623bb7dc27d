#include "modeling/import/lammps_data.h"

#include <filesystem>
#include <fstream>
#include <numbers>

#include <catch2/catch.hpp>
#include <zlib.h>

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
      {"# bond", "# peri", "p:14:1: the atoms are of style \"peri\"; write them with atom_style bond"},
      {"2 4\n", "2 -4\n", "p:12:3: the mass is \"-4\"; give a number above 0"},
      {"2 4\n", "", "p:16:1: atoms of type 2 have no mass"},
      {"0 0 0 0\n", "0 0 1 0\n", "p:17:1: this atom lies in another image of the box, and the header states"},
      {"0 0 0 0\n", "0 0 x 0\n", "p:17:16: the image flag is \"x\""},
      {"10 1 2 1 0 0", "10 1 2 0 0 0",
       "p:28:1: bond 1 joins atoms that are in one place, those of lines 16 and 17"},
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

/// A chain of four atoms that goes through the face of a box of 10, in LAMMPS' words.
std::string chain(const std::string& box, const std::string& atoms, const std::string& more = "") {
  return "a chain\n\n4 atoms\n3 bonds\n1 atom types\n1 bond types\n" + box + "\nMasses\n\n1 1\n\n" + atoms +
         "\nBonds\n\n1 1 1 2\n2 1 2 3\n3 1 3 4\n" + more;
}
const char* const kCube = "0 10 xlo xhi\n0 10 ylo yhi\n0 10 zlo zhi\n";
const char* const kAcross = "Atoms # bond\n\n1 1 1 8.5 1 1\n2 1 1 9.5 1 1\n3 1 1 0.5 1 1\n4 1 1 1.5 1 1\n";

/// The lengths of its bonds.
std::vector<double> lengths(const modeling::LammpsData& data) {
  std::vector<double> all;
  for (const modeling::LammpsBond& bond : data.bonds)
    all.push_back((data.positions[bond.a] - data.positions[bond.b]).norm());
  return all;
}

void checkChain(const std::string& text) {
  const auto data = parseLammpsData(text, "p");
  if (!data) FAIL(data.problem().line());
  REQUIRE(data->bonds.size() == 3);
  for (const double length : lengths(*data)) CHECK(length == Approx(1.0));
}

TEST_CASE("image flags unwrap positions, in boxes of every form, and where there are none bonds do") {
  const std::string flagged =
      "Atoms # bond\n\n1 1 1 8.5 1 1 0 0 0\n2 1 1 9.5 1 1 0 0 0\n3 1 1 0.5 1 1 1 0 0\n4 1 1 1.5 1 1 1 0 0\n";
  checkChain(chain(kCube, flagged));
  checkChain(chain(kCube, kAcross));
  CHECK(parseLammpsData(chain(kCube, flagged), "p")->notes.empty());
  CHECK(parseLammpsData(chain(kCube, kAcross), "p")->notes.size() == 1);
  checkChain(chain("10 0 0 avec\n0 10 0 bvec\n0 0 10 cvec\n0 0 0 abc origin\n", kAcross));
  // Up and through the top of a box that leans by 3 along x.
  const std::string leaning = std::string(kCube) + "0 3 0 xy xz yz\n";
  checkChain(chain(leaning, "Atoms # bond\n\n1 1 1 5 1 8.5\n2 1 1 5 1 9.5\n3 1 1 2 1 0.5\n4 1 1 2 1 1.5\n"));
  checkChain(chain(leaning,
                   "Atoms # bond\n\n1 1 1 5 1 8.5 0 0 0\n2 1 1 5 1 9.5 0 0 0\n3 1 1 2 1 0.5 0 0 1\n4 1 1 2 1 "
                   "1.5 0 0 1\n"));
}

TEST_CASE("bonds as long as the box of a thin plate are no bonds through its faces") {
  // One cell high in a box that fits, as boundaries that shrink leave it, and in one that is a little larger.
  for (const char* const top : {"1", "1.3"}) {
    const std::string box = "0 10 xlo xhi\n0 10 ylo yhi\n0 " + std::string(top) + " zlo zhi\n";
    checkChain(chain(box, "Atoms\n\n1 1 1 1 1 0\n2 1 1 1 1 1\n3 1 1 2 1 1\n4 1 1 2 1 0\n"));
    CHECK(parseLammpsData(chain(box, "Atoms\n\n1 1 1 1 1 0\n2 1 1 1 1 1\n3 1 1 2 1 1\n4 1 1 2 1 0\n"), "p")
              ->notes.empty());
  }
}

TEST_CASE("a ring that closes through the box is refused by the number of a bond") {
  std::string text =
      "a ring\n\n4 atoms\n4 bonds\n1 atom types\n1 bond types\n" + std::string(kCube) +
      "\nMasses\n\n1 1\n\nAtoms\n\n1 1 1 1 1 1\n2 1 1 3.5 1 1\n3 1 1 6 1 1\n4 1 1 8.5 1 1\n\nBonds\n\n"
      "1 1 1 2\n2 1 2 3\n3 1 3 4\n7 1 4 1\n";
  const auto data = parseLammpsData(text, "p");
  REQUIRE_FALSE(data.ok());
  CHECK_THAT(data.problem().line(),
             Catch::Contains("bond 7 joins atoms 7.5 apart, or 2.5 through") && Catch::Contains("ring"));
}

TEST_CASE("other styles of atoms are read where they are stated") {
  const std::vector<std::pair<std::string, std::string>> styles{
      {"full", "1 1 1 0.5 8.5 1 1\n2 1 1 0 9.5 1 1\n3 1 1 0 10.5 1 1\n4 1 1 -1 11.5 1 1\n"},
      {"molecular", "1 1 1 8.5 1 1\n2 1 1 9.5 1 1\n3 1 1 10.5 1 1\n4 1 1 11.5 1 1\n"},
      {"atomic", "1 1 8.5 1 1\n2 1 9.5 1 1\n3 1 10.5 1 1\n4 1 11.5 1 1\n"},
      {"charge", "1 1 2 8.5 1 1 0 0 0\n2 1 2 9.5 1 1 0 0 0\n3 1 2 10.5 1 1 0 0 0\n4 1 2 11.5 1 1 0 0 0\n"},
      {"sphere", "1 1 2 3 8.5 1 1\n2 1 2 3 9.5 1 1\n3 1 2 3 10.5 1 1\n4 1 2 3 11.5 1 1\n"}};
  for (const auto& [style, atoms] : styles) {
    INFO(style);
    const std::string text = chain(kCube, "Atoms # " + style + "\n\n" + atoms);
    checkChain(text);
    // A ball of diameter 2 and density 3.
    if (style == "sphere") CHECK(parseLammpsData(text, "p")->masses[0] == Approx(4.0 * std::numbers::pi));
  }
}

TEST_CASE("labels of types, counts of nothing and sections of constants are no problem") {
  std::string text =
      chain(std::string("0 impropers\n0 improper types\n3 angle types\n0 angles\n0 crossterms\n") + kCube,
            kAcross, "\nAngle Coeffs # harmonic\n\nclay-clay harmonic 3 90\n\nImpropers\n");
  const auto put = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  put("\nMasses\n\n1 1\n",
      "\nAtom Type Labels\n\n1 clay\n\nBond Type Labels\n\n1 thread\n\nMasses\n\nclay 1\n");
  put("1 1 1 8.5", "1 1 clay 8.5");
  put("1 1 1 2\n", "1 thread 1 2\n");
  checkChain(text);
  const auto other = parseLammpsData(text + "\n1 1 1 2 3 4\n", "p");
  REQUIRE_FALSE(other.ok());
  CHECK_THAT(other.problem().line(), Catch::Contains("\"Impropers\""));
  put("1 thread", "1 string");
  CHECK_FALSE(parseLammpsData(text, "p").ok());
}

TEST_CASE("a data file that gzip packed is read, one cut off or packed otherwise is told") {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "smithereens-chain.data.gz";
  const std::string text = chain(kCube, kAcross);
  const gzFile packed = gzopen(file.c_str(), "wb");
  REQUIRE(gzwrite(packed, text.data(), static_cast<unsigned>(text.size())) > 0);
  gzclose(packed);
  const auto data = modeling::loadLammpsData(file);
  if (!data) FAIL(data.problem().line());
  CHECK(data->positions.size() == 4);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 12);
  CHECK_THAT(modeling::loadLammpsData(file).problem().line(), Catch::Contains("cut off"));
  std::ofstream(file, std::ios::binary) << "BZh91AY";
  CHECK_THAT(modeling::loadLammpsData(file).problem().line(), Catch::Contains("packed by bzip2"));
  std::filesystem::remove(file);
}

}  // namespace
