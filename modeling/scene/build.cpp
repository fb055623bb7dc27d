#include "modeling/scene/build.h"

#include <sstream>

#include "modeling/assembly/assembly.h"
#include "modeling/scene/build_parts.h"
#include "modeling/scene/read_obstacles.h"
#include "modeling/scene/tracks.h"
#include "modeling/text/spelling.h"

namespace modeling {
namespace {

/// Below this, contacts slip between a cell's nodes and the step gets small.
constexpr double kPoorJacobian = 0.2;
constexpr double kPoorAspect = 8.0;

std::vector<PartReport> reportsOf(const std::vector<AssemblyPart>& parts, const GlueResult& glued) {
  std::vector<PartReport> reports;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const AssemblyPart& part = parts[p];
    const std::size_t cells = part.lattice.cells.size() - glued.droppedCells[p].size();
    PartReport& report = reports.emplace_back(PartReport{part.name, part.lattice.nodes.size(), cells, {}});
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

sim::Settings settingsOf(const Solver& solver) {
  sim::Settings settings;
  settings.method = solver.method;
  settings.step = solver.step.seconds;
  settings.tolerance = solver.step.tolerance;
  settings.safety = solver.safety;
  settings.seed = solver.seed;
  settings.skip = solver.skip;
  settings.contact.kind = solver.contact.kind;
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
  std::vector<std::string> names;
  for (const sim::Material& material : materials) names.push_back(material.name);
  conditions.tracks = simulationTracks(scene, names);
  conditions.settings = settingsOf(scene.solver);
  return conditions;
}

sim::Result<BuiltScene> build(const Scene& given, const std::filesystem::path& folder,
                              const Attendance& attendance) {
  if (const sim::Status status = checkScene(given); !status) return status.problem();
  BuiltScene built;
  built.scene = given;
  std::vector<std::string> remarks;
  if (const sim::Status status = readObstacles(built.scene, folder, remarks, attendance); !status)
    return status.problem();
  const Scene& scene = built.scene;
  sim::Result<BuiltParts> parts = buildParts(scene, folder, attendance);
  if (!parts) return parts.problem();
  const sim::Result<GlueResult> glued = glue(glueParts(parts->parts), glueSettings(scene, parts->parts));
  if (!glued) return glued.problem();
  sim::Result<sim::Blueprint> blueprint = assemble(parts->parts, parts->materials, *glued);
  if (!blueprint) return blueprint.problem();
  sim::Result<sim::Network> network = sim::buildNetwork(std::move(blueprint).value(), scene.solver.seed);
  if (!network) return network.problem();

  built.network = std::move(network).value();
  built.conditions = conditionsOf(scene, built.network.materials);
  built.parts = reportsOf(parts->parts, *glued);
  built.glue = glued->reports;
  built.warnings = std::move(remarks);
  built.warnings.insert(built.warnings.end(), parts->remarks.begin(), parts->remarks.end());
  for (std::string& warning : warningsOf(built)) built.warnings.push_back(std::move(warning));
  return built;
}

}  // namespace modeling
