#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "modeling/import/lammps_data.h"
#include "sim/take/take.h"
#include "tests/support/run_program.h"

/// Runs carried to LAMMPS and back, where it is installed.
namespace {

using sim::Vec3;

bool haveLammps() {
  if (tests::runCommand("command -v lmp && command -v mpirun").status == 0) return true;
  WARN("lammps or mpirun is not installed: carrying runs there and back was not tested");
  return false;
}

/// A leaning slab that meets the floor. `more` is added to the material, `collider` to the floor.
struct SlabScene {
  std::string size = "[3, 3, 1]";
  double cellSize = 0.5;
  std::string more = {};
  std::string collider = {};
  std::string colliders = {};  ///< more of them
  double step = 1e-5;
  double fps = 1000.0;
  double duration = 0.004;
  double height = 1.0;

  std::string text() const {
    return R"({"smithereens": 1, "name": "slab", "materials": {"m": {"youngsModulus": 1e8)" + more +
           R"(}}, "parts": [{"name": "slab", "kind": "slab", "material": "m", "size": )" + size +
           R"(, "resolution": {"cellSize": )" + std::to_string(cellSize) +
           R"(}, "worldFromPart": {"position": [0, 0, )" + std::to_string(height) +
           R"(], "rotation": [20, 10, 0]}, "velocity": [0, 0, -200]}], "environment": {"colliders": )" +
           R"([{"name": "floor", "kind": "floor")" + collider + "}" + colliders +
           R"(]}, "solver": {"contact": {"kind": "nodes"}, "step": )" + std::to_string(step) +
           R"(}, "output": {"fps": )" + std::to_string(fps) + R"(, "duration": )" + std::to_string(duration) +
           "}}";
  }
};

/// The same scene by us and by LAMMPS.
struct BothRuns {
  std::unique_ptr<sim::TakeReader> ours, theirs;

  BothRuns(const SlabScene& scene, const std::string& launcher) {
    const std::string folder = tests::freshFolder("smithereens-lammps");
    const std::string file = folder + "/slab.scene.json";
    std::ofstream(file) << scene.text();
    need(tests::runCli("simulate " + file + " --take " + folder + "/ours.take"));
    need(tests::runCli("export " + folder + "/ours.take --frames 0 --format lammps --out " + folder +
                       "/slab"));
    need(tests::runCommand("cd " + folder + " && OMP_NUM_THREADS=1 " + launcher +
                           " lmp -in slab.in -log none"));
    need(tests::runCli("import-lammps " + folder + "/slab.dump --scene " + file + " --take " + folder +
                       "/theirs.take"));
    ours = std::move(*sim::TakeReader::open(folder + "/ours.take"));
    theirs = std::move(*sim::TakeReader::open(folder + "/theirs.take"));
  }

  static void need(const tests::Answer& answer) {
    INFO(answer.output.substr(answer.output.size() - std::min<std::size_t>(answer.output.size(), 2000)));
    INFO(answer.errors);
    REQUIRE(answer.status == 0);
  }

  /// How far any node is from where we have it, over how far any has come, in a frame.
  double apart(std::size_t frame) const {
    const auto start = *ours->frame(0);
    const auto left = *ours->frame(frame);
    const auto right = *theirs->frame(frame);
    REQUIRE(std::abs(left->time - right->time) < 1e-9);
    double apart = 0.0;
    double moved = 0.0;
    for (std::size_t node = 0; node < left->positions.size(); ++node) {
      apart = std::max(apart, (left->positions[node] - right->positions[node]).norm());
      moved = std::max(moved, (left->positions[node] - start->positions[node]).norm());
    }
    return apart / moved;
  }
};

const char* const kOneRank = "";
const char* const kTwoRanks = "mpirun --allow-run-as-root --oversubscribe --mca mpi_yield_when_idle 1 -np 2";
const char* const kFourRanks = "mpirun --allow-run-as-root --oversubscribe --mca mpi_yield_when_idle 1 -np 4";

TEST_CASE("LAMMPS moves an undamped lattice as we do, and pushes it off a rough floor alike, on two ranks") {
  if (!haveLammps()) return;
  const BothRuns runs({.more = R"(, "lossFactor": 1e-12)", .collider = R"(, "friction": 0.3)"}, kTwoRanks);
  REQUIRE(runs.theirs->frameCount() == runs.ours->frameCount());
  // Four hundred steps of rounding.
  for (std::size_t frame = 1; frame < runs.ours->frameCount(); ++frame) CHECK(runs.apart(frame) < 1e-10);
}

TEST_CASE("LAMMPS pushes off boxes, cylinders and balls, however they are turned, as we do") {
  if (!haveLammps()) return;
  // Under different corners of the slab, all met within the first millisecond.
  const BothRuns runs(
      {.more = R"(, "lossFactor": 1e-12)",
       .colliders =
           R"(, {"name": "block", "kind": "box", "halfSize": [0.8, 0.5, 0.7], "position": [-1, -1, 0.35],
                           "rotation": [10, 30, 20], "friction": 0.3},
                        {"name": "roller", "kind": "cylinder", "radius": 0.6, "halfHeight": 0.9,
                         "position": [1, 0.9, 0.45], "rotation": [80, 0, 30], "friction": 0.2},
                        {"name": "ball", "kind": "sphere", "radius": 0.5, "position": [-1, 1, 0.6]})",
       .height = 1.6},
      kTwoRanks);
  REQUIRE(runs.theirs->frameCount() == runs.ours->frameCount());
  for (std::size_t frame = 1; frame < runs.ours->frameCount(); ++frame) CHECK(runs.apart(frame) < 1e-10);
  // They do push: without them the slab would be elsewhere.
  const BothRuns free({.more = R"(, "lossFactor": 1e-12)", .height = 1.6}, kOneRank);
  const auto start = *runs.ours->frame(0);
  const auto pushed = *runs.ours->frame(4);
  const auto unpushed = *free.ours->frame(4);
  for (const Vec3& collider : {Vec3(-1, -1, 0.35), Vec3(1, 0.9, 0.45), Vec3(-1, 1, 0.6)}) {
    std::size_t nearest = 0;
    for (std::size_t node = 0; node < start->positions.size(); ++node) {
      if ((start->positions[node] - collider).norm() < (start->positions[nearest] - collider).norm())
        nearest = node;
    }
    CHECK((pushed->positions[nearest] - unpushed->positions[nearest]).norm() > 1e-3);
  }
}

TEST_CASE("damping of nodes stands for damping of bonds to a thousandth of the way") {
  if (!haveLammps()) return;
  const BothRuns damped({.more = R"(, "lossFactor": 0.2)"}, kOneRank);
  for (std::size_t frame = 1; frame < damped.ours->frameCount(); ++frame) CHECK(damped.apart(frame) < 1e-3);
}

TEST_CASE("what breaks on LAMMPS comes back broken, in fragments that keep their nodes") {
  if (!haveLammps()) return;
  const BothRuns runs(
      {.more = R"(, "threshold": {"mean": 0.004, "spread": 0.2})", .duration = 0.02, .height = 0.8},
      kOneRank);
  const sim::TakeReader& take = *runs.theirs;
  REQUIRE(take.frameCount() == 21);
  const auto last = *take.frame(20);
  REQUIRE(last->fragments.size() > 1);
  std::size_t nodes = 0;
  for (const sim::Fragment& fragment : last->broken->fragments) {
    nodes += fragment.nodeCount;
    CHECK((fragment.parent == sim::kNone) == (fragment.born == 0.0));
  }
  CHECK(nodes == take.network().nodeCount());
  std::size_t broken = 0;
  for (const std::uint8_t bond : last->broken->bonds) broken += bond;
  CHECK(broken > 0);
  CHECK(take.events()->size() == broken);
  for (sim::NodeIndex a = 0; a < take.network().nodeCount(); ++a) {
    for (sim::BondIndex b = take.network().firstBond[a]; b < take.network().firstBond[a + 1]; ++b) {
      if (last->broken->bonds[b] == 0)
        CHECK(last->broken->fragmentOfNode[a] == last->broken->fragmentOfNode[take.network().bondEnds[b]]);
    }
  }
}

/// Energies that LAMMPS itself states, in its own units: what moves, what is strained or pushes, what is
/// high, and what the floor, the first collider, holds of nodes that are in it (k X^2 / 2).
std::vector<double> energiesOfRun(const std::string& folder, const std::string& name) {
  std::ifstream stream(folder + "/" + name + ".in");
  std::string script(std::istreambuf_iterator<char>(stream), {});
  const auto at = script.find("thermo_modify");
  REQUIRE(at != std::string::npos);
  const auto gravity = script.find("fix gravity moving gravity ");
  std::string pull = "0";
  if (gravity != std::string::npos) std::istringstream(script.substr(gravity + 27)) >> pull;
  script.insert(at, "variable high equal " + pull +
                        "*mass(all)*xcm(all,z)\nvariable pressed atom \"(v_h1<0)*0.5*v_k1*v_h1^2\"\n"
                        "compute pressed all reduce sum v_pressed\nthermo 20\n"
                        "thermo_style custom step ke pe v_high c_pressed\n"
                        "thermo_modify norm no format float %20.12g\n");
  std::ofstream(folder + "/energy.in") << script;
  const auto answer = tests::runCommand("cd " + folder + " && OMP_NUM_THREADS=1 lmp -in energy.in -log none");
  BothRuns::need(answer);
  std::vector<double> energies;
  std::istringstream lines(answer.output.substr(answer.output.rfind("Step ")));
  std::string line;
  std::getline(lines, line);
  double step = 0, moving = 0, strained = 0, high = 0, pressed = 0;
  while (std::getline(lines, line) &&
         std::istringstream(line) >> step >> moving >> strained >> high >> pressed)
    energies.push_back(moving + strained + high + pressed);
  return energies;
}

/// How far the energy ever rises above what it was before, relative to what it was at first.
double largestRise(const std::vector<double>& energies) {
  double least = energies.front();
  double rise = 0.0;
  for (const double energy : energies) {
    rise = std::max(rise, energy - least);
    least = std::min(least, energy);
  }
  return rise / energies.front();
}

TEST_CASE("what breaks on LAMMPS never gains energy by it") {
  if (!haveLammps()) return;
  // Undamped and damped, of few and of many kinds of bonds, at rest and stretched: a spinning slab that flies
  // apart, and one that breaks on the floor.
  const std::string brittle = R"(, "threshold": {"mean": 0.01, "spread": 0.2})";
  const std::string spin = R"(, "angularVelocity": [300, 0, 500])";
  struct Case {
    SlabScene scene;
    std::string more;
  };
  const std::vector<Case> cases{
      {{.more = R"(, "lossFactor": 1e-12)" + brittle, .duration = 0.01, .height = 5.0}, spin},
      {{.more = R"(, "lossFactor": 0.4)" + brittle, .duration = 0.01, .height = 5.0}, spin},
      {{.cellSize = 0.37,
        .more = R"(, "lossFactor": 0.2, "threshold": {"mean": 0.004, "spread": 0.2})",
        .duration = 0.01,
        .height = 0.8},
       ""}};
  for (const auto& [scene, more] : cases) {
    const std::string folder = tests::freshFolder("smithereens-lammps");
    std::string text = scene.text();
    text.insert(text.find("\"velocity\"") - 2, more);
    std::ofstream(folder + "/slab.scene.json") << text;
    BothRuns::need(tests::runCli("simulate " + folder + "/slab.scene.json --take " + folder + "/a.take"));
    BothRuns::need(
        tests::runCli("export " + folder + "/a.take --frames 0 --format lammps --out " + folder + "/slab"));
    const std::vector<double> energies = energiesOfRun(folder, "slab");
    REQUIRE(energies.size() > 20);
    std::ifstream bonds(folder + "/slab.bonds");
    std::size_t first = 0, last = 0;
    for (std::string line; std::getline(bonds, line);) {
      if (line != "ITEM: NUMBER OF ENTRIES") continue;
      bonds >> last;
      if (first == 0) first = last;
    }
    CHECK(last < first);
    // The integrator's own waver at half the largest stable step.
    CHECK(largestRise(energies) < 2e-3);
  }
}

TEST_CASE("bonds of many kinds keep their own thresholds on LAMMPS, and with them their spread") {
  const std::string folder = tests::freshFolder("smithereens-lammps");
  const std::string scene = "\"" SMITHEREENS_SOURCE_DIR "/resources/scenes/cup-roll.scene.json\"";
  BothRuns::need(tests::runCli("simulate " + scene + " --until 0.001 --take " + folder + "/cup.take"));
  BothRuns::need(
      tests::runCli("export " + folder + "/cup.take --frames 0 --format lammps --out " + folder + "/cup"));
  // As LAMMPS reads it: lengths at rest and at breaking, by the two bonds that a pair has.
  std::map<std::size_t, double> rest, most;
  std::ifstream script(folder + "/cup.in");
  for (std::string line; std::getline(script, line);) {
    std::istringstream words(line);
    std::string command, types, style;
    words >> command >> types >> style;
    double skip = 0.0, length = 0.0;
    if (command != "bond_coeff" || (style != "harmonic" && style != "quartic")) continue;
    for (int i = 0; i < (style == "harmonic" ? 1 : 3); ++i) words >> skip;
    words >> length;
    const std::size_t first = std::stoul(types);
    const std::size_t star = types.find('*');
    const std::size_t last = star == std::string::npos ? first : std::stoul(types.substr(star + 1));
    for (std::size_t type = first; type <= last; ++type) (style == "harmonic" ? rest : most)[type] = length;
  }
  const auto take = *sim::TakeReader::open(folder + "/cup.take");
  const sim::Network& network = take->network();
  std::map<std::pair<std::size_t, std::size_t>, std::array<double, 2>> pairs;
  std::ifstream data(folder + "/cup.data");
  for (std::string line; std::getline(data, line) && line != "Bonds";) {
  }
  std::size_t id = 0, type = 0, a = 0, b = 0;
  while (data >> id >> type >> a >> b) {
    if (rest.contains(type)) pairs[{a, b}][0] = rest.at(type);
    if (most.contains(type)) pairs[{a, b}][1] = most.at(type);
  }
  REQUIRE(pairs.size() == network.bondCount());
  double sum = 0.0, squares = 0.0, worst = 0.0;
  for (const auto& [ends, lengths] : pairs) {
    const auto bond = network.findBond(static_cast<sim::NodeIndex>(ends.first) - 1,
                                       static_cast<sim::NodeIndex>(ends.second) - 1);
    const double threshold = lengths[1] / lengths[0] - 1.0;
    worst = std::max(worst, std::abs(threshold / static_cast<double>(network.thresholds[bond]) - 1.0));
    sum += threshold;
    squares += threshold * threshold;
  }
  const auto count = static_cast<double>(pairs.size());
  // The scene's 0.2, less what is cut off beyond three deviations; of 8989 bonds it wavers by a hundredth.
  CHECK(std::sqrt(squares * count / (sum * sum) - 1.0) == Approx(0.2).epsilon(0.03));
  CHECK(worst < 1e-6);
}

TEST_CASE("a run that goes on from a later frame comes back as one, by the number of its first step") {
  if (!haveLammps()) return;
  const std::string folder = tests::freshFolder("smithereens-lammps");
  const std::string file = folder + "/slab.scene.json";
  std::ofstream(file)
      << SlabScene{.more = R"(, "threshold": {"mean": 0.3, "spread": 0.2})", .height = 1.0}.text();
  BothRuns::need(tests::runCli("simulate " + file + " --take " + folder + "/a.take"));
  BothRuns::need(
      tests::runCli("export " + folder + "/a.take --frames 3 --format lammps --out " + folder + "/slab"));
  BothRuns::need(tests::runCommand("cd " + folder + " && OMP_NUM_THREADS=1 lmp -in slab.in -log none"));
  BothRuns::need(tests::runCli("import-lammps " + folder + "/slab.dump --scene " + file + " --take " +
                               folder + "/b.take"));
  const auto ours = *sim::TakeReader::open(folder + "/a.take");
  const auto theirs = *sim::TakeReader::open(folder + "/b.take");
  REQUIRE(theirs->frameCount() == 2);
  for (std::size_t node = 0; node < ours->network().nodeCount(); ++node)
    CHECK(((*ours->frame(3))->positions[node] - (*theirs->frame(0))->positions[node]).norm() < 1e-12);
}

/// Three nodes and two bonds along each edge of a cube of 2 cm.
void checkCube(const std::string& file) {
  const auto data = modeling::loadLammpsData(file);
  INFO(file);
  if (!data) FAIL(data.problem().line());
  CHECK(data->positions.size() == 27);
  CHECK(data->bonds.size() == 54);
  Eigen::AlignedBox3d box;
  for (const Vec3& position : data->positions) box.extend(position);
  CHECK((box.sizes() - Vec3(2, 2, 2)).norm() < 1e-9);
}

TEST_CASE("a cube that LAMMPS writes across the corner of its periodic box is read whole") {
  if (!haveLammps()) return;
  const std::string folder = tests::freshFolder("smithereens-lammps");
  for (const std::string& shape :
       {std::string("block 0 4 0 4 0 4"), std::string("prism 0 4 0 4 0 4 1 0 0")}) {
    std::ofstream(folder + "/cube.in")
        << "units lj\nboundary p p p\natom_style full\nlattice sc 1\nregion all " << shape
        << "\ncreate_box 1 all bond/types 1 extra/bond/per/atom 6 extra/special/per/atom 50\n"
           "region cube block 0.9 3.1 -0.1 2.1 -0.1 2.1\ncreate_atoms 1 region cube\nmass 1 1.5\n"
           "pair_style zero 1.5\npair_coeff * *\nbond_style zero\nbond_coeff *\n"
           "create_bonds many all all 1 0.9 1.1\ndisplace_atoms all move 1.6 2.6 2.6 units box\nrun 0\n"
           "write_data cube.data\n";
    BothRuns::need(tests::runCommand("cd " + folder + " && OMP_NUM_THREADS=1 lmp -in cube.in -log none"));
    // With its image flags, and as if it had none, packed.
    BothRuns::need(tests::runCommand(
        "cd " + folder + " && awk 'NF == 10 {NF = 7} 1' cube.data > plain.data && gzip -kf plain.data"));
    for (const char* const name : {"/cube.data", "/plain.data", "/plain.data.gz"}) checkCube(folder + name);
  }
}

/// A test of its own for ctest, readers-large: it takes a minute.
TEST_CASE("a hundred thousand nodes go to four ranks and come back as we have them", "[large]") {
  if (!haveLammps()) return;
  const BothRuns runs({.size = "[13, 13, 4.6]",
                       .cellSize = 0.2,
                       .more = R"(, "lossFactor": 0.2, "threshold": {"mean": 0.3, "spread": 0.2})",
                       .step = 5e-6,
                       .duration = 0.002,
                       .height = 3.45},
                      kFourRanks);
  REQUIRE(runs.ours->network().nodeCount() > 100000);
  CHECK(runs.ours->events()->empty());
  for (std::size_t frame = 1; frame < runs.ours->frameCount(); ++frame) {
    INFO("frame " << frame);
    CHECK(runs.apart(frame) < 1e-3);
  }
}

}  // namespace
