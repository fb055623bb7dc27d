#include "modeling/scene/build.h"

#include <algorithm>
#include <numbers>
#include <sstream>

#include "modeling/assembly/assembly.h"
#include "modeling/scene/build_parts.h"
#include "modeling/scene/read_obstacles.h"
#include "modeling/text/spelling.h"

namespace modeling {
namespace {

/// Below this, contacts slip between a cell's nodes and the step gets small.
constexpr double kPoorJacobian = 0.2;
constexpr double kPoorAspect = 8.0;

template <class Items>
std::size_t indexOf(const Items& items, const std::string& name) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
  return static_cast<std::size_t>(found - items.begin());
}

std::vector<PartReport> reportsOf(const std::vector<AssemblyPart>& parts) {
  std::vector<PartReport> reports;
  for (const AssemblyPart& part : parts) {
    PartReport& report = reports.emplace_back(PartReport{part.name, part.lattice.nodes.size(), {}});
    if (!part.lattice.cells.empty()) report.quality = measure(part.lattice);
  }
  return reports;
}

std::vector<std::string> warningsOf(const BuiltScene& built) {
  std::vector<std::string> warnings;
  const auto warn = [&](const auto&... words) {
    std::ostringstream text;
    text.precision(3);
    (text << ... << words);
    warnings.push_back(text.str());
  };
  for (const PartReport& part : built.parts) {
    if (part.quality.maxAspect == 0.0) continue;
    const std::string name = inQuotes(part.name);
    if (part.quality.minScaledJacobian < kPoorJacobian) {
      warn("the part ", name, " has a badly skewed cell (scaled Jacobian ", part.quality.minScaledJacobian,
           ")");
    }
    if (part.quality.maxAspect > kPoorAspect) {
      warn("the part ", name, " has a narrow cell (", part.quality.maxAspect, " times as long as wide)");
    }
  }
  for (const GlueReport& glue : built.glue) {
    const std::string pair = inQuotes(glue.a) + " to " + inQuotes(glue.b);
    if (glue.nodesTaken > 0) {
      warn("gluing ", pair, " left ", glue.nodesTaken, " nodes out that an earlier gluing had dropped");
    }
    if (glue.worstScaledJacobian < kPoorJacobian) {
      warn("gluing ", pair, " skews a cell badly (scaled Jacobian ", glue.worstScaledJacobian, ")");
    }
  }
  return warnings;
}

sim::Track trackOf(const SceneTrack& written) {
  sim::Track track;
  track.target = written.target.target;
  track.interpolation = written.interpolation;
  const bool degrees = track.target == sim::TrackTarget::colliderRotation;
  for (const SceneTrackKey& key : written.keys) {
    const double* number = std::get_if<double>(&key.value);
    const Vec3 value = number != nullptr ? Vec3(*number, 0.0, 0.0) : std::get<Vec3>(key.value);
    track.keys.push_back({key.time, degrees ? Vec3(value * (std::numbers::pi / 180.0)) : value});
  }
  return track;
}

void addTracks(const SceneTrack& written, const sim::Environment& environment,
               const std::vector<sim::Material>& materials, std::vector<sim::Track>& tracks) {
  sim::Track track = trackOf(written);
  const TargetName& target = written.target;
  if (target.object.empty()) {
    tracks.push_back(track);
    return;
  }
  if (target.isVector()) {
    track.object = static_cast<std::uint32_t>(indexOf(environment.colliders, target.object));
    tracks.push_back(track);
    return;
  }
  for (std::uint32_t i = 0; i < materials.size(); ++i) {
    if (materials[i].name != target.object) continue;
    track.object = i;
    tracks.push_back(track);
  }
}

sim::Settings settingsOf(const Solver& solver) {
  sim::Settings settings;
  settings.method = solver.method;
  settings.precision = solver.precision;
  settings.step = solver.step.seconds;
  settings.tolerance = solver.step.tolerance;
  settings.safety = solver.safety;
  settings.seed = solver.seed;
  settings.skip = solver.skip;
  settings.contact.between = solver.contact.between;
  settings.contact.self = solver.contact.self;
  settings.contact.length = solver.contact.length;
  settings.contact.stiffnessScale = solver.contact.stiffnessScale;
  settings.contact.dampingRatio = solver.contact.dampingRatio;
  settings.contact.friction = solver.contact.friction;
  return settings;
}

}  // namespace

Conditions conditionsOf(const Scene& scene, const std::vector<sim::Material>& materials) {
  Conditions conditions;
  conditions.environment.gravity = scene.environment.gravity;
  for (const SceneCollider& collider : scene.environment.colliders) {
    conditions.environment.colliders.push_back(colliderOf(collider));
  }
  for (const SceneTrack& track : scene.tracks) {
    addTracks(track, conditions.environment, materials, conditions.tracks);
  }
  conditions.settings = settingsOf(scene.solver);
  return conditions;
}

sim::Result<BuiltScene> build(const Scene& given, const std::filesystem::path& folder) {
  if (const sim::Status status = checkScene(given); !status) return status.problem();
  BuiltScene built;
  built.scene = given;
  std::vector<std::string> remarks;
  if (const sim::Status status = readObstacles(built.scene, folder, remarks); !status)
    return status.problem();
  const Scene& scene = built.scene;
  sim::Result<BuiltParts> parts = buildParts(scene, folder);
  if (!parts) return parts.problem();
  const sim::Result<GlueResult> glued = glue(glueParts(parts->parts), glueSettings(scene, parts->parts));
  if (!glued) return glued.problem();
  sim::Result<sim::Blueprint> blueprint = assemble(parts->parts, parts->materials, *glued);
  if (!blueprint) return blueprint.problem();
  sim::Result<sim::Network> network = sim::buildNetwork(std::move(blueprint).value(), scene.solver.seed);
  if (!network) return network.problem();

  built.network = std::move(network).value();
  built.conditions = conditionsOf(scene, built.network.materials);
  built.parts = reportsOf(parts->parts);
  built.glue = glued->reports;
  built.warnings = std::move(remarks);
  built.warnings.insert(built.warnings.end(), parts->remarks.begin(), parts->remarks.end());
  for (std::string& warning : warningsOf(built)) built.warnings.push_back(std::move(warning));
  return built;
}

}  // namespace modeling
