#include "app/cli/describe.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include <Eigen/Geometry>

#include "app/cli/command.h"
#include "app/cli/progress.h"
#include "app/cli/waiting.h"
#include "modeling/import/lammps_data.h"
#include "modeling/preflight/preflight.h"
#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "sim/methods/method_names.h"
#include "sim/take/take.h"

namespace app {
namespace {

using modeling::BuiltScene;

/// As many of the worst cells are told of.
constexpr std::size_t kMostCells = 5;

Json vectorJson(const sim::Vec3& vector) {
  return Json::Array{vector.x(), vector.y(), vector.z()};
}

void addCounts(const sim::Network& network, Json& info) {
  info["nodes"] = network.nodeCount();
  info["bonds"] = network.bondCount();
  info["cells"] = network.cellCount();
}

void addExtent(const std::vector<sim::Vec3>& positions, const std::vector<double>& masses, Json& info) {
  Eigen::AlignedBox3d box;
  for (const sim::Vec3& position : positions) box.extend(position);
  double mass = 0.0;
  for (const double share : masses) mass += std::isfinite(share) ? share : 0.0;
  info["box_min_cm"] = vectorJson(box.min());
  info["box_max_cm"] = vectorJson(box.max());
  info["mass_g"] = mass;
}

Json partsJson(const std::vector<modeling::PartReport>& parts) {
  Json::Array list;
  for (const modeling::PartReport& part : parts) {
    Json& entry = list.emplace_back(Json{{"name", part.name}, {"nodes", part.nodes}});
    const modeling::LatticeQuality& quality = part.quality;
    if (quality.volume == 0.0) continue;
    entry["volume_cm3"] = quality.volume;
    entry["mean_edge_cm"] = quality.meanEdge;
    entry["min_edge_cm"] = quality.minEdge;
    entry["worst_scaled_jacobian"] = quality.minScaledJacobian;
    entry["most_skewed_cell"] = quality.mostSkewedCell;
    entry["worst_aspect"] = quality.maxAspect;
    entry["longest_cell"] = quality.longestCell;
  }
  return list;
}

Json glueJson(const std::vector<modeling::GlueReport>& reports) {
  Json::Array list;
  for (const modeling::GlueReport& glue : reports) {
    list.push_back(Json{{"a", glue.a},
                        {"b", glue.b},
                        {"nodes_merged", glue.nodesMerged},
                        {"bonds_zeroed", glue.bondsZeroed},
                        {"bonds_duplicate", glue.bondsDuplicate},
                        {"cells_dropped", glue.cellsDropped},
                        {"wedges", glue.wedges},
                        {"cells_bent", glue.bent},
                        {"worst_distance_cm", glue.worstDistance},
                        {"worst_scaled_jacobian", glue.worstScaledJacobian}});
  }
  return list;
}

std::string_view nameOf(sim::StepLimit limit) {
  switch (limit) {
    case sim::StepLimit::none:
      return "nothing";
    case sim::StepLimit::fixed:
      return "the scene";
    case sim::StepLimit::lattice:
      return "the lattice";
    case sim::StepLimit::contact:
      return "contact";
    case sim::StepLimit::tolerance:
      return "the tolerance";
  }
  return "";
}

Json worstCellsJson(const std::vector<modeling::PoorCell>& cells) {
  Json::Array list;
  for (std::size_t i = 0; i < std::min(cells.size(), kMostCells); ++i) {
    list.push_back(Json{{"part", cells[i].part},
                        {"cell", cells[i].cell},
                        {"scaled_jacobian", cells[i].scaledJacobian},
                        {"aspect", cells[i].aspect}});
  }
  return list;
}

Json overlapsJson(const std::vector<modeling::Overlap>& overlaps) {
  Json::Array list;
  for (const modeling::Overlap& overlap : overlaps) {
    const bool isOfParts = overlap.kind == modeling::Overlap::Kind::parts;
    Json& entry = list.emplace_back(Json{{"part", overlap.part},
                                         {isOfParts ? "other_part" : "obstacle", overlap.other},
                                         {"depth_cm", overlap.depth},
                                         {"at_cm", vectorJson(overlap.at)}});
    if (!overlap.mend) continue;
    entry["to_move"] = overlap.mend->part;
    entry["move_cm"] = vectorJson(overlap.mend->move);
  }
  return list;
}

Json preflightJson(const modeling::Preflight& flight) {
  return {{"bonds_broken_at_rest", flight.brokenAtRestCount},
          {"components", flight.components},
          {"stable_step_s", flight.stableStep},
          {"stable_step_limited_by", nameOf(flight.stableStepLimit)},
          {"step_s", flight.step},
          {"steps", flight.steps},
          {"memory_bytes", flight.peakMemoryBytes},
          {"expected_wall_s", flight.wallSeconds},
          {"expected_wall_s_per_s", flight.wallSecondsPerSecond},
          {"expected_take_bytes", flight.takeBytes},
          {"frames", flight.frames},
          {"worst_cells", worstCellsJson(flight.worstCells)},
          {"overlaps", overlapsJson(flight.overlaps)}};
}

std::string beginningOf(const std::filesystem::path& file) {
  std::string start(16, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(stream.gcount()));
  const std::size_t text = start.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return text == std::string::npos ? "" : start.substr(text);
}

}  // namespace

sim::Result<Json> describeScene(const std::filesystem::path& file) {
  const sim::Result<modeling::SceneFile> scene = modeling::loadScene(file);
  if (!scene) return scene.problem();
  tell(scene->notes);
  sim::Result<BuiltScene> built = modeling::build(scene->scene, file.parent_path(), Waiting().attendance());
  if (!built) return scene->located(built.problem());
  Json info = {{"kind", "scene"}, {"name", scene->scene.name}};
  addCounts(built->network, info);
  addExtent(built->network.positions, built->network.masses, info);
  info["method"] = sim::nameOf(scene->scene.solver.method);
  info["duration_s"] = scene->scene.output.duration;
  info["parts"] = partsJson(built->parts);
  info["glue"] = glueJson(built->glue);
  info["warnings"] = Json::Array();  // its place; what is found below stands in it, too
  const sim::Result<modeling::Preflight> flight = modeling::preflight(scene->scene, *built);
  if (!flight) return scene->located(flight.problem());
  info["preflight"] = preflightJson(*flight);
  std::vector<std::string> warnings = built->warnings;
  for (const modeling::Overlap& overlap : flight->overlaps) warnings.push_back(modeling::sentence(overlap));
  if (flight->wallSeconds > kVeryLong) {
    warnings.push_back("the run would take about " + roughTime(flight->wallSeconds) +
                       " on this machine; larger cells, a softer material or a shorter run are quicker");
  }
  info["warnings"] = warnings;
  return info;
}

sim::Result<Json> describeTake(const std::filesystem::path& file) {
  const auto opened = sim::TakeReader::open(file);
  if (!opened) return opened.problem();
  const sim::TakeReader& take = **opened;
  Json info = {{"kind", "take"}};
  const auto scene = modeling::parseScene(take.header().scene, "scene");
  if (scene) info["name"] = scene->scene.name;
  addCounts(take.network(), info);
  addExtent(take.network().positions, take.network().masses, info);
  info["frames"] = take.frameCount();
  info["frames_per_second"] = take.header().framesPerSecond;
  info["duration_s"] = take.frameCount() > 0 ? take.frameTime(take.frameCount() - 1) : 0.0;
  info["checkpoints"] = take.checkpointFrames().size();
  if (take.frameCount() > 0) {
    const auto last = take.frame(take.frameCount() - 1);
    if (!last) return last.problem();
    info["steps"] = (*last)->stepCount;
    info["fragments"] = (*last)->fragments.size();
    info["broken_bonds"] = (*last)->broken->lostBonds();
  }
  info["seed"] = take.header().seed;
  info["scene_hash"] = take.header().sceneHash;
  std::error_code error;
  info["bytes"] = std::filesystem::file_size(file, error);
  info["dropped_bytes"] = take.droppedBytes();
  info["outcome"] = take.outcome().value_or("not finished");
  return info;
}

sim::Result<Json> describeNetwork(const std::filesystem::path& file) {
  const sim::Result<modeling::LammpsData> data = modeling::loadLammpsData(file);
  if (!data) return data.problem();
  Json info = {{"kind", "network"}, {"nodes", data->positions.size()}, {"bonds", data->bonds.size()}};
  std::map<int, std::size_t> types;
  for (const modeling::LammpsBond& bond : data->bonds) ++types[bond.type];
  for (const auto& [type, count] : types) info["bonds_by_type"][std::to_string(type)] = count;
  addExtent(data->positions, data->masses, info);
  info["has_velocities"] = !data->velocities.empty();
  if (!data->notes.empty()) info["notes"] = data->notes;
  return info;
}

sim::Result<Json> describe(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".json") return describeScene(file);
  if (extension == ".take") return describeTake(file);
  if (extension == ".data") return describeNetwork(file);
  const std::string start = beginningOf(file);
  if (start.starts_with('{')) return describeScene(file);
  if (start.find("SMTAKE") != std::string::npos) return describeTake(file);
  return describeNetwork(file);
}

}  // namespace app
