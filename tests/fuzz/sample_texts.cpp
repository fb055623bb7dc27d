#include "tests/fuzz/sample_texts.h"

#include <sstream>

#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "tests/modeling/scene_examples.h"

namespace tests {
namespace {

const char* const kHead = R"({"smithereens": 1, "materials": {
  "clay": {"youngsModulus": 1e7, "lossFactor": 0.4, "threshold": {"mean": 0.003, "spread": 0.2}}}, )";

const char* const kTable = R"("parts": [
    {"name": "block", "kind": "slab", "material": "clay", "size": [2, 2, 2], "resolution": {"cellSize": 1}},
    {"name": "vase", "kind": "revolution", "material": "clay",
     "outside": [[[2, 5], [2, 0]], [[2, 0], [0, 0]]], "inside": [[[1.2, 5], [1.2, 0.8]], [[1.2, 0.8], [0, 0.8]]],
     "resolution": {"cellSize": 1, "counts": [8, null, 1]}, "worldFromPart": {"position": [10, 0, 0]}}],
  "environment": {"colliders": [{"name": "floor", "kind": "floor", "dampingRatio": 0.8}]},
  "solver": {"contact": {"dampingRatio": 0.8}}})";

const char* const kGlued = R"("parts": [
    {"name": "a", "kind": "slab", "material": "clay", "size": [2, 2, 1], "resolution": {"cellSize": 0.5}},
    {"name": "b", "kind": "slab", "material": "clay", "size": [1, 1, 2], "resolution": {"cellSize": 0.5},
     "worldFromPart": {"position": [0, 0, 1]}},
    {"name": "c", "kind": "slab", "material": "clay", "size": [1, 1, 1], "resolution": {"cellSize": 0.5},
     "worldFromPart": {"position": [1.5, 0, 0.5]}}],
  "glue": [{"a": "b", "b": "a", "reach": 0.3}, {"a": "c", "b": "a", "reach": 0.5, "exclude": [1],
     "region": {"min": [-9, -9, -9], "max": [9, 9, 9]}}]})";

const char* const kObstacles = R"("parts": [
    {"name": "a", "kind": "slab", "material": "clay", "size": [3, 3, 1], "resolution": {"cellSize": 0.5}},
    {"name": "b", "kind": "slab", "material": "clay", "size": [3, 1, 1], "resolution": {"cellSize": 0.5},
     "worldFromPart": {"position": [1, 0, 0.5], "rotation": [0, 10, 20]}}],
  "environment": {"colliders": [
    {"name": "floor", "kind": "floor", "position": [0, 0, 0.1]},
    {"name": "box", "kind": "box", "halfSize": [1, 1, 1], "position": [2, 0, 0]},
    {"name": "ball", "kind": "sphere", "radius": 1, "position": [0, 2, 0], "active": [0, 0.5]},
    {"name": "pin", "kind": "cylinder", "radius": 0.1, "halfHeight": 3, "position": [0.2, 0.2, 0]}]},
  "output": {"fps": 100, "duration": 0.1}})";

const char* const kShapes = R"("parts": [
    {"name": "leaf", "kind": "patch", "material": "clay", "thickness": 0.3, "resolution": {"cellSize": 0.5},
     "net": [[[0, 0, 0], [0, 1, 0], [0, 2, 0], [0, 3, 0]], [[1, 0, 1], [1, 1, 1], [1, 2, 1], [1, 3, 1]],
             [[2, 0, 1], [2, 1, 1], [2, 2, 1], [2, 3, 1]], [[3, 0, 0], [3, 1, 0], [3, 2, 0], [3, 3, 0]]]},
    {"name": "spout", "kind": "curvedCylinder", "material": "clay", "resolution": {"cellSize": 0.5},
     "curve": [[[9, 0, 0], [9, 0, 2], [9, 1, 3], [9, 3, 4]]], "section": "ring", "halfWidth": 0.8, "halfDepth": 0.8,
     "wallThickness": 0.3},
    {"name": "half", "kind": "revolution", "material": "clay", "turnAngle": 180, "correspondence": "segments",
     "outside": [[[2, 3], [2, 0]]], "inside": [[[1, 3], [1, 0]]], "resolution": {"cellSize": 0.7},
     "worldFromPart": {"position": [0, 9, 0], "scale": [1, 1, 0.5]}, "hold": [{"min": [-9, -9, -9], "max": [9, 9, 0.1]}]}]})";

const char* const kTracks = R"("parts": [
    {"name": "a", "kind": "slab", "material": "clay", "size": [2, 2, 1], "resolution": {"cellSize": 1}}],
  "environment": {"colliders": [{"name": "floor", "kind": "floor"},
    {"name": "ball", "kind": "sphere", "radius": 1, "position": [0, 0, 4]}]},
  "tracks": [
    {"target": "gravity.scale", "keys": [[0, 1], [0.02, 3]]},
    {"target": "stiffness.scale", "keys": [[0.005, 1], [0.01, 0.8]], "interpolation": "smooth"},
    {"target": "damping.scale.clay", "keys": [[0, 1], [0.1, 2]], "interpolation": "step"},
    {"target": "gravity", "keys": [[0, [0, 0, -981]], [0.03, [50, 0, -981]]]},
    {"target": "collider.ball.position", "keys": [[0, [0, 0, 4]], [0.04, [0, 0, 3]]]},
    {"target": "collider.floor.rotation", "keys": [[0, [0, 0, 0]], [0.1, [10, 0, 0]]]}],
  "solver": {"method": "velocity-verlet", "step": {"tolerance": 1e-4}},
  "output": {"fps": 30, "duration": 0.1}})";

/// A square of nodes with its diagonals.
std::string bar() {
  return "a bar\n\n8 atoms\n7 bonds\n1 atom types\n2 bond types\n\n0 8 xlo xhi\n-1 1 ylo yhi\n-1 1 zlo "
         "zhi\n\nMasses\n\n1 0.5\n\n"
         "Atoms # bond\n\n1 1 1 0 0 0\n2 1 1 1 0 0\n3 1 1 2 0 0\n4 1 1 3 0 0\n5 1 1 4 0 0\n6 1 1 5 0 0\n7 1 "
         "1 6 0 0\n"
         "8 1 1 7 0 0\n\nVelocities\n\n1 0 0 0\n2 0 0 1\n3 0 0 0\n4 0 1 0\n5 0 0 0\n6 0 0 0\n7 0 0 0\n8 0 0 "
         "0\n\n"
         "Bonds\n\n1 1 1 2\n2 1 2 3\n3 2 3 4\n4 1 4 5\n5 1 5 6\n6 1 6 7\n7 2 7 8\n";
}

/// Two moments of what dumpedScene() makes; of the later one some bonds are gone.
void addDumps(std::map<std::string, std::string>& texts) {
  const auto scene = modeling::parseScene(texts.at("dump/scene.json"), "sample");
  if (!scene) return;
  const auto built = modeling::build(scene->scene, "");
  if (!built) return;
  const sim::Network& network = built->network;
  std::ostringstream nodes, bonds;
  nodes.precision(17);
  const char* const box = "\nITEM: BOX BOUNDS mm mm mm\n-9 9\n-9 9\n-9 9\n";
  for (int moment = 0; moment < 2; ++moment) {
    nodes << "ITEM: TIME\n"
          << 0.25 * moment << "\nITEM: TIMESTEP\n"
          << 10 * moment << "\nITEM: NUMBER OF ATOMS\n"
          << network.nodeCount() << box << "ITEM: ATOMS id x y z vx vy vz\n";
    for (std::size_t node = network.nodeCount(); node-- > 0;)
      nodes << node + 1 << " " << (network.positions[node] + sim::Vec3(0.1, 0.2, 0.3) * moment).transpose()
            << " 1 2 3\n";
    std::ostringstream rows;
    std::size_t count = 0;
    for (sim::NodeIndex a = moment == 0 ? 0 : 1; a < network.nodeCount(); ++a) {
      for (sim::BondIndex b = network.firstBond[a]; b < network.firstBond[a + 1]; ++b, ++count)
        rows << network.bondEnds[b] + 1 << " " << a + 1 << "\n";
    }
    bonds << "ITEM: TIMESTEP\n"
          << 10 * moment << "\nITEM: NUMBER OF ENTRIES\n"
          << count << box << "ITEM: ENTRIES c_pairs[1] c_pairs[2] \n"
          << rows.str();
  }
  texts["dump/run.dump"] = nodes.str();
  texts["dump/run.bonds"] = bonds.str();
}

}  // namespace

std::string breakingScene() {
  return std::string(kHead) +
         R"("parts": [{"name": "glass", "kind": "slab", "material": "clay", "size": [3, 3, 0.5],
    "resolution": {"cellSize": 0.5}, "velocity": [0, 0, -300], "worldFromPart": {"position": [0, 0, 0.2]}}],
    "environment": {"colliders": [{"name": "edge", "kind": "box", "halfSize": [0.5, 9, 0.1]}]},
    "output": {"fps": 400, "duration": 0.05}})";
}

std::map<std::string, std::string> sampleTexts() {
  std::map<std::string, std::string> texts;
  texts["scene/full.scene.json"] = kFullScene;
  texts["scene/bar.data"] = bar();
  texts["scene/table.scene.json"] = std::string(kHead) + kTable;
  texts["scene/glued.scene.json"] = std::string(kHead) + kGlued;
  texts["scene/obstacles.scene.json"] = std::string(kHead) + kObstacles;
  texts["scene/shapes.scene.json"] = std::string(kHead) + kShapes;
  texts["tracks/tracks.scene.json"] = std::string(kHead) + kTracks;
  texts["network/bar.data"] = bar();
  texts["dump/scene.json"] = std::string(kHead) + R"("parts": [
    {"name": "a", "kind": "slab", "material": "clay", "size": [2, 1, 1], "resolution": {"cellSize": 1}}]})";
  addDumps(texts);
  texts["kept/slab.scene.json"] = breakingScene();
  texts["kept/takes.json"] =
      R"([{"file": "run.take", "name": "The good one", "note": "lands flat", "continuedAt": 0.02,
    "made": "2026-01-02T03:04:05"}, {"file": "gone.take", "name": "", "made": ""}])";
  texts["recovery/autosave.scene.json"] = breakingScene();
  texts["recovery/autosave.json"] = R"({"file": "/somewhere/slab.scene.json", "when": "2026-01-02T03:04:05",
    "takes": {"run.take": {"name": "One", "note": "a note"}}})";
  texts["report/report.json"] =
      R"({"outcome": "done", "fragments": 3, "isolated_nodes": 0, "broken_bonds": 17,
    "largest_fragments": [20, 10, 5], "energy": {"kinetic": 1e3, "max_rise": 1e-7}, "state_hash": "0123456789abcdef",
    "events": {"first_break_s": null, "breaks": 17}, "wall_s": 0.5, "step_s": 2e-6})";
  return texts;
}

}  // namespace tests
