#include "ui/editors/glue_preview.h"

#include <algorithm>
#include <map>
#include <set>

#include "modeling/glue/nearest.h"
#include "ui/session/background_thread.h"

namespace ui {
namespace {

using modeling::GluePart;
using modeling::Gluing;
using modeling::NodeIndex;
using modeling::Scene;
using modeling::Vec3;

/// The scene with nothing in it but what bears on one gluing: it and those before it that are joined to it
/// through parts, and the parts. The gluing is the last.
Scene joinedTo(const Scene& scene, std::size_t index) {
  std::set<std::string> names{scene.glue[index].a, scene.glue[index].b};
  for (std::size_t before = 0; before != names.size();) {
    before = names.size();
    for (std::size_t i = 0; i < index; ++i) {
      const Gluing& gluing = scene.glue[i];
      if (names.contains(gluing.a) || names.contains(gluing.b)) names.insert({gluing.a, gluing.b});
    }
  }
  Scene joined;
  joined.materials = scene.materials;
  for (const modeling::Part& part : scene.parts)
    if (names.contains(part.name)) joined.parts.push_back(part);
  for (std::size_t i = 0; i <= index; ++i)
    if (names.contains(scene.glue[i].a)) joined.glue.push_back(scene.glue[i]);
  return joined;
}

/// Where each node of the merged list comes from.
std::map<NodeIndex, std::pair<std::size_t, NodeIndex>> sourcesOf(const modeling::GlueResult& glued) {
  std::map<NodeIndex, std::pair<std::size_t, NodeIndex>> sources;
  for (std::size_t part = 0; part < glued.globalNode.size(); ++part)
    for (NodeIndex node = 0; node < glued.globalNode[part].size(); ++node)
      if (glued.gluedBy[part][node] == sim::kNone) sources[glued.globalNode[part][node]] = {part, node};
  return sources;
}

std::vector<GlueLink> linksOf(const std::vector<GluePart>& parts, std::size_t a,
                              const modeling::GlueResult& glued) {
  const auto last = static_cast<std::uint32_t>(glued.reports.size() - 1);
  const auto sources = sourcesOf(glued);
  std::vector<GlueLink> links;
  for (NodeIndex node = 0; node < parts[a].nodes.size(); ++node) {
    if (glued.gluedBy[a][node] != last) continue;
    const auto& [part, other] = sources.at(glued.globalNode[a][node]);
    links.push_back({node, other, parts[a].nodes[node], parts[part].nodes[other]});
  }
  return links;
}

std::vector<GlueLink> freedOf(const GluePart& a, const GluePart& b, const Gluing& gluing) {
  std::vector<GlueLink> freed;
  if (!gluing.pairs.empty()) return freed;
  const modeling::NearestPoints nearest(b.nodes);
  for (const NodeIndex node : gluing.exclude) {
    if (node >= a.nodes.size()) continue;
    const auto found = nearest.nearest(a.nodes[node], gluing.reach);
    if (found) freed.push_back({node, found->point, a.nodes[node], b.nodes[found->point]});
  }
  return freed;
}

std::optional<GlueLink> nearestOf(const GluePart& a, const GluePart& b) {
  constexpr double kAnywhere = 1e12;  // cm
  const modeling::NearestPoints index(b.nodes);
  std::optional<GlueLink> best;
  for (NodeIndex node = 0; node < a.nodes.size(); ++node) {
    const auto found = index.nearest(a.nodes[node], best ? best->distance() : kAnywhere);
    if (found && (!best || found->distance < best->distance()))
      best = GlueLink{node, found->point, a.nodes[node], b.nodes[found->point]};
  }
  return best;
}

}  // namespace

std::optional<sim::Problem> GluePreviewer::prepare(const Scene& scene, const std::filesystem::path& folder) {
  if (built_ && parts_ == scene.parts && folder_ == folder) return std::nullopt;
  built_.reset();
  auto built = modeling::buildParts(scene, folder);
  if (!built) return built.problem();
  parts_ = scene.parts;
  folder_ = folder;
  built_ = std::move(built).value();
  glueParts_ = modeling::glueParts(built_->parts);
  return std::nullopt;
}

GlueOutcome GluePreviewer::outcome(const Scene& scene, std::size_t index,
                                   const std::filesystem::path& folder) {
  GlueOutcome outcome;
  outcome.gluing = scene.glue[index];
  try {
    const Scene joined = joinedTo(scene, index);
    outcome.problem = prepare(joined, folder);
    if (outcome.problem) return outcome;
    const std::vector<modeling::GlueSettings> settings = modeling::glueSettings(joined, built_->parts);
    const std::size_t a = settings.back().a;
    const std::size_t b = settings.back().b;
    if (a >= glueParts_.size() || b >= glueParts_.size()) {
      outcome.problem = sim::Problem{"", "a part to glue does not exist", "choose two of the scene's parts"};
      return outcome;
    }
    const auto glued = modeling::glue(glueParts_, settings);
    outcome.freed = freedOf(glueParts_[a], glueParts_[b], outcome.gluing);
    if (!glued) {
      outcome.problem = glued.problem();
      const auto nearest = nearestOf(glueParts_[a], glueParts_[b]);
      if (nearest && nearest->distance() > outcome.gluing.reach) outcome.nearest = nearest;
      return outcome;
    }
    outcome.report = glued->reports.back();
    outcome.links = linksOf(glueParts_, a, *glued);
  } catch (...) {
    outcome.problem = problemOfException();
  }
  return outcome;
}

}  // namespace ui
