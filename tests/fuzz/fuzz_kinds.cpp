#include "tests/fuzz/fuzz_kinds.h"

#include <fstream>
#include <random>
#include <stdexcept>

#include <ImfRgbaFile.h>
#include <nlohmann/json.hpp>

#include "app/results/json.h"
#include "modeling/exchange/lammps_import.h"
#include "modeling/import/lammps_data.h"
#include "modeling/import/mesh_file.h"
#include "modeling/run/recording.h"
#include "modeling/scene/build.h"
#include "modeling/scene/salvage.h"
#include "modeling/scene/scene_file.h"
#include "sim/take/take.h"
#include "tests/fuzz/text_cuts.h"
#include "tests/modeling/scene_examples.h"
#include "ui/picture/environment_file.h"
#include "ui/picture/image.h"

namespace tests {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Random = std::mt19937_64;

const std::string kTracks =
    R"({"smithereens": 1, "materials": {"clay": {"youngsModulus": 1e7, "threshold": {"mean": 0.01}}},
 "parts": [{"name": "a", "kind": "slab", "material": "clay", "size": [2, 2, 1], "resolution": {"cellSize": 1}},
           {"name": "b", "kind": "slab", "material": "clay", "size": [2, 2, 1], "resolution": {"cellSize": 1},
            "worldFromPart": {"position": [0, 0, 1]}}],
 "glue": [{"a": "b", "b": "a", "reach": 0.1}],
 "environment": {"colliders": [{"name": "ball", "kind": "sphere", "radius": 1, "position": [0, 0, -2]}]},
 "tracks": [{"target": "gravity.scale", "keys": [[0, 1], [0.5, 5]]}, {"target": "gravity", "keys": [[0, [0, 0, -981]]]},
  {"target": "stiffness.scale.clay", "keys": [[0, 1], [1, 2]]},
  {"target": "collider.ball.position", "keys": [[0, [0, 0, -2]], [1, [0, 0, 3]]], "interpolation": "smooth"}],
 "output": {"fps": 1000, "duration": 0.01}})";

const std::string kBar =
    "bar\n\n3 atoms\n2 bonds\n1 atom types\n1 bond types\n\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo "
    "zhi\n\nMasses\n\n1 1\n\n"
    "Atoms # bond\n\n1 1 1 1 1 1\n2 1 1 2 1 1\n3 1 1 3 1 1\n\nVelocities\n\n1 0 0 1\n2 0 0 1\n3 0 0 1\n\n"
    "Bonds\n\n1 1 1 2\n2 1 2 3\n";
const std::string kBarScene =
    R"({"smithereens": 1, "parts": [{"name": "bar", "kind": "network", "file": "bar.data",
 "format": "lammps", "bondTypes": {"1": {"stiffness": 1000}}}]})";

const std::string kObj =
    "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
const std::string kStl =
    "solid t\nfacet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 2 0\nvertex 2 0 0\nendloop\nendfacet\n"
    "facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 0 2\nendloop\nendfacet\n"
    "facet normal 1 1 1\nouter loop\nvertex 2 0 0\nvertex 0 2 0\nvertex 0 0 2\nendloop\nendfacet\n"
    "facet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 2\nvertex 0 2 0\nendloop\nendfacet\nendsolid "
    "t\n";

std::string bytesOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A Problem says something; else it is a fault of ours.
template <class Value>
bool told(const sim::Result<Value>& result) {
  if (result) return true;
  if (result.problem().what.empty()) throw std::runtime_error("a problem without words");
  return false;
}

bool readScene(const fs::path& file) {
  const auto scene = modeling::loadScene(file);
  if (!told(scene)) return false;
  const auto again = modeling::parseScene(modeling::writeScene(scene->scene), "again");
  if (!again || !(again->scene == scene->scene))
    throw std::runtime_error("written and read again it is another scene");
  auto built = modeling::build(scene->scene, file.parent_path());
  if (!told(built)) return false;
  const auto simulation = sim::Simulation::create(std::move(built->network), built->conditions.environment,
                                                  built->conditions.tracks, built->conditions.settings);
  if (!told(simulation)) return false;
  for (int step = 0; step < 3; ++step)
    if (!told((*simulation)->stepOnce())) return false;
  return true;
}

bool readTake(const fs::path& file) {
  const auto opened = sim::TakeReader::open(file);
  if (!told(opened)) return false;
  const sim::TakeReader& take = **opened;
  if (const auto broken = take.network().validate())
    throw std::runtime_error("an invalid network: " + *broken);
  bool good = true;
  for (std::size_t frame = 0; frame < take.frameCount(); ++frame)
    good = told(take.frame(frame)) && told(take.eventsOf(frame)) && told(take.sceneOf(frame)) && good;
  const auto scene = modeling::parseScene(take.header().scene, "s");
  if (!told(scene)) return false;
  for (const std::size_t frame : take.checkpointFrames()) {
    const auto checkpoint = take.checkpoint(frame);
    if (!told(checkpoint)) continue;
    const modeling::Conditions conditions = modeling::conditionsOf(scene->scene, take.network().materials);
    const auto simulation = sim::Simulation::create(take.network(), conditions.environment, conditions.tracks,
                                                    conditions.settings);
    if (told(simulation) && told((*simulation)->restore(*checkpoint))) told((*simulation)->stepOnce());
  }
  return good;
}

bool readData(const fs::path& file) {
  return told(modeling::loadLammpsData(file));
}

bool readDump(const fs::path& file) {
  const auto scene = modeling::loadScene(file.parent_path() / "bar.scene.json");
  const auto built = modeling::build(scene->scene, file.parent_path());
  return told(modeling::importLammps({file, {}}, built->scene, built->network, file.string() + ".take"));
}

bool readMesh(const fs::path& file) {
  return told(modeling::loadMesh(file.parent_path(), {file.filename().string()}));
}

bool readImage(const fs::path& file) {
  return told(ui::readEnvironment(file));
}

bool readReport(const fs::path& file) {
  return app::parseJson(bytesOf(file)).has_value();
}

std::string takeBytes(const fs::path& folder) {
  const auto scene = modeling::parseScene(kTracks, "s");
  auto built = modeling::build(scene->scene, folder);
  auto simulation = sim::Simulation::create(std::move(built->network), built->conditions.environment,
                                            built->conditions.tracks, built->conditions.settings);
  auto take = modeling::createTake(folder / "whole.take", built->scene, (*simulation)->network());
  auto recording = modeling::Recording::ofNewRun(**simulation, std::move(*take), {1000.0, 0.01});
  if (!recording.run({})) throw std::runtime_error("the whole take was not made");
  return bytesOf(folder / "whole.take");
}

std::string exrBytes(const fs::path& folder) {
  const std::vector<Imf::Rgba> pixels(8 * 4, Imf::Rgba(0.5F, 1.0F, 2.0F));
  {
    Imf::RgbaOutputFile file((folder / "whole.exr").c_str(), 8, 4, Imf::WRITE_RGB);
    file.setFrameBuffer(pixels.data(), 1, 8);
    file.writePixels(4);
  }
  return bytesOf(folder / "whole.exr");
}

std::string pngBytes(const fs::path& folder) {
  ui::Image image{.width = 8, .height = 4, .samples = {}};
  for (unsigned i = 0; i < 3 * 8 * 4; ++i) image.samples.push_back(static_cast<std::uint16_t>(977 * i));
  if (!ui::writePng(folder / "whole.png", image)) throw std::runtime_error("the whole PNG was not made");
  return bytesOf(folder / "whole.png");
}

std::string hdrBytes() {
  std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n";
  for (int row = 0; row < 4; ++row) {
    bytes += std::string("\x02\x02\x00\x08", 4);
    for (int share = 0; share < 4; ++share) bytes += std::string("\x84\x81\x04\x10\x20\x30\x40", 7);
  }
  return bytes;
}

std::string dumpText() {
  std::string text;
  for (int moment = 0; moment < 3; ++moment) {
    text += "ITEM: TIME\n" + std::to_string(0.01 * moment) + "\nITEM: TIMESTEP\n" +
            std::to_string(100 * moment) +
            "\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS ff ff ff\n0 9\n0 9\n0 9\nITEM: ATOMS id x y z vx "
            "vy vz\n"
            "1 1 1 1 0 0 1\n2 2 1 1 0 0 1\n3 3 1 1 0 0 1\n";
  }
  return text;
}

std::size_t below(Random& random, std::size_t limit) {
  return limit == 0 ? 0 : random() % limit;
}

/// A value within goes, comes twice, changes its place with another, or becomes something else.
std::string restructured(const std::string& text, Random& random) {
  Json root = Json::parse(text, nullptr, false);
  if (root.is_discarded() || !root.is_structured()) return text;
  const Json flat = root.flatten();
  const auto pointer = [&] {
    auto at = flat.begin();
    std::advance(at, static_cast<std::ptrdiff_t>(below(random, flat.size())));
    Json::json_pointer found(at.key());
    for (std::size_t up = below(random, 3); up > 0 && found.parent_pointer() != Json::json_pointer(); --up)
      found = found.parent_pointer();
    return found;
  };
  static const Json kOthers[] = {
      nullptr, true, -1, 0, 1e300, "text", Json::array(), Json::object(), 18446744073709551615U};
  const Json::json_pointer one = pointer();
  Json& place = root[one];
  switch (below(random, 4)) {
    case 0:
      place = kOthers[below(random, std::size(kOthers))];
      break;
    case 1:
      place = Json(root[pointer()]);
      break;
    case 2:
      if (place.is_array() && !place.empty()) place.push_back(Json(place[below(random, place.size())]));
      break;
    default:
      if (Json& outer = root[one.parent_pointer()]; outer.is_object()) outer.erase(one.back());
  }
  return root.dump();
}

std::string withFlippedBits(std::string bytes, Random& random) {
  if (bytes.empty()) return bytes;
  for (std::size_t count = 1 + below(random, 8); count > 0; --count) {
    char& byte = bytes[below(random, bytes.size())];
    byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << below(random, 8)));
  }
  return bytes;
}

/// A piece of one file in the middle of another of its kind.
std::string spliced(const std::string& bytes, const std::string& other, Random& random) {
  const std::size_t from = below(random, other.size());
  const std::size_t at = below(random, bytes.size());
  return bytes.substr(0, at) + other.substr(from, 1 + below(random, 200)) +
         bytes.substr(std::min(bytes.size(), at + below(random, 200)));
}

}  // namespace

std::vector<FuzzKind> fuzzKinds(const fs::path& folder) {
  std::ofstream(folder / "bar.data") << kBar;
  std::ofstream(folder / "bar.scene.json") << kBarScene;
  return {{"scene", ".scene.json", {tests::kPlainScene, kTracks, kBarScene}, true, readScene},
          {"take", ".take", {takeBytes(folder)}, false, readTake},
          {"data", ".data", {kBar}, true, readData},
          {"dump", ".dump", {dumpText()}, true, readDump},
          {"obj", ".obj", {kObj}, true, readMesh},
          {"stl", ".stl", {kStl}, true, readMesh},
          {"hdr", ".hdr", {hdrBytes()}, false, readImage},
          {"png", ".png", {pngBytes(folder)}, false, readImage},
          {"exr", ".exr", {exrBytes(folder)}, false, readImage},
          {"report",
           ".json",
           {R"({"steps": 12, "outcome": "done", "energy": {"total": 1.5}, "list": [1, 2, [3]]})"},
           true,
           readReport}};
}

std::string spoiled(const FuzzKind& kind, std::uint64_t seed) {
  Random random(seed);
  std::string bytes = kind.wholes[below(random, kind.wholes.size())];
  for (std::size_t count = 1 + below(random, 3); count > 0; --count) {
    switch (below(random, kind.isText ? 5 : 3)) {
      case 0:
        bytes = withFlippedBits(std::move(bytes), random);
        break;
      case 1:
        bytes = spliced(bytes, kind.wholes[below(random, kind.wholes.size())], random);
        break;
      case 2:
        bytes = bytes.substr(0, below(random, bytes.size()));
        break;
      case 3:
        bytes = damaged(bytes, random());
        break;
      default:
        bytes = restructured(bytes, random);
    }
  }
  return bytes;
}

}  // namespace tests
