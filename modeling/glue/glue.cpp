#include "modeling/glue/glue.h"

#include <algorithm>
#include <cstdio>
#include <unordered_map>
#include <unordered_set>

#include "modeling/glue/nearest.h"
#include "modeling/shapes/quality.h"
#include "sim/network/wedge.h"

namespace modeling {
namespace {

using sim::kNone;

/// Below this scaled Jacobian a cell counts as misshapen, if it was twice as good before: what stiffness a
/// fit to it finds would be more and more noise.
constexpr double kMisshapen = 0.1;

/// A wedge of less than this share of the cell's volume before is a sliver, and not worth having. One with a
/// corner that is bent in is: without it there would be a hole.
constexpr double kSliver = 0.05;

using Bond = std::array<NodeIndex, 2>;

/// Calls visit(x, y), x < y, for every pair of corners of the part's cells for which wanted(cell) holds, and
/// every loose bond; each pair once.
template <class Wanted, class Visit>
void forEachBond(const GluePart& part, const Wanted& wanted, const Visit& visit) {
  std::vector<Bond> bonds;
  for (const sim::CellCorners& cell : part.cells) {
    if (!wanted(cell)) continue;
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t j = 0; j < i; ++j)
        bonds.push_back({std::min(cell[i], cell[j]), std::max(cell[i], cell[j])});
  }
  for (const Bond& bond : part.looseBonds)
    bonds.push_back({std::min(bond[0], bond[1]), std::max(bond[0], bond[1])});
  std::sort(bonds.begin(), bonds.end());
  bonds.erase(std::unique(bonds.begin(), bonds.end()), bonds.end());
  for (const Bond& bond : bonds) visit(bond[0], bond[1]);
}

std::uint64_t pairKey(NodeIndex x, NodeIndex y) {
  return (static_cast<std::uint64_t>(std::min(x, y)) << 32U) | std::max(x, y);
}

class Gluer {
 public:
  Gluer(const std::vector<GluePart>& parts, const std::vector<GlueSettings>& glues)
      : parts_(parts), glues_(glues) {
    for (const GluePart& part : parts) {
      firstNode_.push_back(static_cast<NodeIndex>(follow_.size()));
      for (std::size_t node = 0; node < part.nodes.size(); ++node)
        follow_.push_back(static_cast<NodeIndex>(follow_.size()));
      result_.gluedBy.emplace_back(part.nodes.size(), kNone);
    }
  }

  sim::Result<GlueResult> run() {
    for (std::size_t index = 0; index < glues_.size(); ++index)
      if (auto problem = apply(index)) {
        problem->place = placeOf(index) + (problem->place.empty() ? "" : "." + problem->place);
        return *problem;
      }
    numberNodes();
    if (auto problem = checkCells()) return *problem;
    countZeroed();
    countDuplicates();
    return std::move(result_);
  }

 private:
  static std::string placeOf(std::size_t index) { return "glue[" + std::to_string(index) + "]"; }

  /// Where a node of all parts' nodes in a row ended up after the gluings so far.
  NodeIndex root(NodeIndex node) {
    while (follow_[node] != node) node = follow_[node] = follow_[follow_[node]];
    return node;
  }

  std::optional<sim::Problem> checkParts(std::size_t index) const {
    const GlueSettings& settings = glues_[index];
    if (settings.a >= parts_.size() || settings.b >= parts_.size())
      return sim::Problem{"", "a part to glue does not exist", "name two of the scene's parts"};
    const auto samePair = [&](const GlueSettings& other) {
      return std::minmax(other.a, other.b) == std::minmax(settings.a, settings.b);
    };
    const auto end = glues_.begin() + static_cast<std::ptrdiff_t>(index);
    const auto before = std::find_if(glues_.begin(), end, samePair);
    if (before == end) return std::nullopt;
    return sim::Problem{"",
                        "'" + parts_[settings.a].name + "' and '" + parts_[settings.b].name +
                            "' are glued already by " +
                            placeOf(static_cast<std::size_t>(before - glues_.begin())),
                        "keep one of the two"};
  }

  /// The part as the gluings so far have left it: its nodes where they are now, and after them those of the
  /// other parts with which it shares cells, so that gluing it further minds those cells too.
  GluePart asItStands(std::size_t index) {
    GluePart part = parts_[index];
    std::unordered_map<NodeIndex, NodeIndex> local;
    const NodeIndex first = firstNode_[index];
    for (NodeIndex node = 0; node < parts_[index].nodes.size(); ++node) {
      part.nodes[node] = position(root(first + node));
      if (result_.gluedBy[index][node] == kNone) local[first + node] = node;
    }
    for (std::size_t other = 0; other < parts_.size(); ++other) {
      if (other == index) continue;
      const auto& gluedBy = result_.gluedBy[other];
      for (const sim::CellCorners& cell : parts_[other].cells) {
        const auto isShared = [&](NodeIndex corner) {
          return gluedBy[corner] != kNone && partOf(root(firstNode_[other] + corner)) == index;
        };
        if (std::none_of(cell.begin(), cell.end(), isShared)) continue;
        sim::CellCorners& shared = part.cells.emplace_back();
        for (std::size_t c = 0; c < 8; ++c) {
          const NodeIndex node = root(firstNode_[other] + cell[c]);
          const auto [entry, isNew] = local.try_emplace(node, static_cast<NodeIndex>(part.nodes.size()));
          if (isNew) part.nodes.push_back(position(node));
          shared[c] = entry->second;
        }
      }
    }
    return part;
  }
  std::size_t partOf(NodeIndex node) const {
    return static_cast<std::size_t>(std::upper_bound(firstNode_.begin(), firstNode_.end(), node) -
                                    firstNode_.begin()) -
           1;
  }
  const Vec3& position(NodeIndex node) const {
    const std::size_t part = partOf(node);
    return parts_[part].nodes[node - firstNode_[part]];
  }

  /// The pairs of a gluing, without the nodes that an earlier one dropped.
  sim::Result<GluePreview> previewRemaining(std::size_t index) {
    GlueSettings settings = glues_[index];
    if (settings.a == settings.b || !settings.explicitPairs.empty())
      return previewGlue(parts_[settings.a], parts_[settings.b], settings);
    for (const NodeIndex node : settings.excludedNodes)
      if (node >= parts_[settings.a].nodes.size())
        return previewGlue(parts_[settings.a], parts_[settings.b], settings);
    const GluePart a = asItStands(settings.a);
    GluePart b = parts_[settings.b];
    for (NodeIndex node = 0; node < b.nodes.size(); ++node)
      b.nodes[node] = position(root(firstNode_[settings.b] + node));
    const std::vector<std::uint32_t>& dropped = result_.gluedBy[settings.a];
    for (NodeIndex node = 0; node < a.nodes.size(); ++node)
      if (node >= dropped.size() || dropped[node] != kNone) settings.excludedNodes.push_back(node);
    return previewGlue(a, b, settings);
  }

  /// Nodes that a gluing would choose, had not an earlier one dropped them.
  std::size_t countTaken(const GlueSettings& settings) const {
    if (!settings.explicitPairs.empty()) return 0;
    const std::vector<std::uint32_t>& dropped = result_.gluedBy[settings.a];
    if (std::all_of(dropped.begin(), dropped.end(), [](std::uint32_t by) { return by == kNone; })) return 0;
    const NearestPoints index(parts_[settings.b].nodes);
    const std::unordered_set<NodeIndex> excluded(settings.excludedNodes.begin(),
                                                 settings.excludedNodes.end());
    std::size_t count = 0;
    for (NodeIndex node = 0; node < dropped.size(); ++node) {
      const Vec3& place = parts_[settings.a].nodes[node];
      if (dropped[node] == kNone || excluded.contains(node)) continue;
      count += index.nearest(place, settings.reach).has_value();
    }
    return count;
  }

  std::optional<sim::Problem> apply(std::size_t index) {
    if (auto problem = checkParts(index)) return *problem;
    const GlueSettings& settings = glues_[index];
    const GluePart& a = parts_[settings.a];
    const GluePart& b = parts_[settings.b];
    GlueReport report;
    report.a = a.name;
    report.b = b.name;
    const auto preview = previewRemaining(index);
    report.nodesTaken = preview ? countTaken(settings) : 0;
    if (!preview) return preview.problem();
    report.nodesReleased = preview->nodesReleased;
    const std::vector<std::uint32_t>& dropped = result_.gluedBy[settings.a];
    for (const GluePair& pair : preview->pairs) {
      const NodeIndex from = root(firstNode_[settings.a] + pair.a),
                      to = root(firstNode_[settings.b] + pair.b);
      if (from == to) {
        ++report.nodesTaken;
        continue;
      }
      if (dropped[pair.a] != kNone)
        return sim::Problem{"",
                            "node " + std::to_string(pair.a) + " of '" + a.name +
                                "' was glued to another node by " + placeOf(dropped[pair.a]),
                            "leave it out of one of the two"};
      follow_[from] = to;
      result_.gluedBy[settings.a][pair.a] = static_cast<std::uint32_t>(index);
      report.worstDistance = std::max(report.worstDistance, pair.distance);
      ++report.nodesMerged;
    }
    result_.reports.push_back(report);
    return std::nullopt;
  }

  void numberNodes() {
    std::vector<NodeIndex> number(follow_.size(), kNone);
    NodeIndex next = 0;
    for (std::size_t part = 0, node = 0; part < parts_.size(); ++part)
      for (std::size_t local = 0; local < parts_[part].nodes.size(); ++local, ++node)
        if (follow_[node] == node) {
          number[node] = next++;
          positions_.push_back(parts_[part].nodes[local]);
        }
    result_.nodeCount = next;
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      auto& global = result_.globalNode.emplace_back();
      for (NodeIndex local = 0; local < parts_[part].nodes.size(); ++local)
        global.push_back(number[root(firstNode_[part] + local)]);
    }
  }

  /// Tells the misshapen cells, drops those that have no volume of their own any more, and refuses those
  /// turned inside out.
  std::optional<sim::Problem> checkCells() {
    result_.droppedCells.resize(parts_.size());
    result_.misshapen.resize(parts_.size());
    for (std::size_t part = 0; part < parts_.size(); ++part)
      for (std::size_t cell = 0; cell < parts_[part].cells.size(); ++cell)
        if (auto problem = checkCell(part, static_cast<sim::CellIndex>(cell))) return problem;
    return std::nullopt;
  }

  static bool isWorthWhile(const sim::CellCorners& wedge, const CornerPositions& corners, double before) {
    return sim::isProperWedge(wedge) && cellVolume(corners) > kSliver * before;
  }

  std::optional<sim::Problem> checkCell(std::size_t part, sim::CellIndex index) {
    const sim::CellCorners& cell = parts_[part].cells[index];
    const auto& gluedBy = result_.gluedBy[part];
    std::uint32_t last = kNone;
    bool allByOne = true;
    for (const NodeIndex corner : cell) {
      if (gluedBy[corner] != kNone && (last == kNone || gluedBy[corner] > last)) last = gluedBy[corner];
      allByOne = allByOne && gluedBy[corner] == gluedBy[cell[0]];
    }
    if (last == kNone) return std::nullopt;
    sim::CellCorners merged;
    CornerPositions corners;
    for (std::size_t c = 0; c < 8; ++c) {
      merged[c] = result_.globalNode[part][cell[c]];
      corners[c] = positions_[merged[c]];
    }
    GlueReport& report = result_.reports[last];
    const double before = cellVolume(cornerPositions(parts_[part].nodes, cell));
    const bool isWedge = sim::isWedge(merged);
    if (allByOne || (isWedge && !isWorthWhile(merged, corners, before))) {
      result_.droppedCells[part].push_back(index);
      ++report.cellsDropped;
      return std::nullopt;
    }
    if (isWedge) {
      result_.misshapen[part].push_back(index);
      ++report.wedges;
      return std::nullopt;
    }
    const double quality = scaledJacobian(corners);
    if (quality > kBentIn && cellVolume(corners) > kSliver * before) {
      if (quality < kMisshapen && quality < 0.5 * scaledJacobian(cornerPositions(parts_[part].nodes, cell))) {
        result_.misshapen[part].push_back(index);
        ++report.bent;
      } else if (report.worstCell == kNone || quality < report.worstScaledJacobian) {
        report.worstScaledJacobian = quality;
        report.worstCell = index;
      }
      return std::nullopt;
    }
    char text[96];
    std::snprintf(text, sizeof text, "(%.3g, %.3g, %.3g)", corners[0].x(), corners[0].y(), corners[0].z());
    return sim::Problem{
        placeOf(last),
        "gluing '" + report.a + "' to '" + report.b + "' would turn a cell inside out near " + text,
        "lower the reach, bring the surfaces nearer together, or make the cells more alike in size"};
  }

  void countZeroed() {
    for (std::uint32_t index = 0; index < glues_.size(); ++index) {
      const std::size_t part = glues_[index].a;
      const auto& gluedBy = result_.gluedBy[part];
      forEachBond(
          parts_[part],
          [&](const sim::CellCorners& cell) {
            return std::any_of(cell.begin(), cell.end(),
                               [&](NodeIndex corner) { return gluedBy[corner] == index; });
          },
          [&](NodeIndex x, NodeIndex y) {
            if (gluedBy[x] == index && gluedBy[y] == index) ++result_.reports[index].bondsZeroed;
          });
    }
  }

  /// Bonds that no gluing touched hold their pairs first; then come the glue bonds, gluing by gluing.
  void countDuplicates() {
    std::vector<bool> target(result_.nodeCount, false);
    for (std::size_t part = 0; part < parts_.size(); ++part)
      for (std::size_t node = 0; node < parts_[part].nodes.size(); ++node)
        if (result_.gluedBy[part][node] != kNone) target[result_.globalNode[part][node]] = true;
    std::unordered_set<std::uint64_t> present;
    std::vector<std::vector<Bond>> glueBonds(glues_.size());
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      const auto& global = result_.globalNode[part];
      const auto& gluedBy = result_.gluedBy[part];
      const auto atTarget = [&](const sim::CellCorners& cell) {
        return std::any_of(cell.begin(), cell.end(),
                           [&](NodeIndex corner) { return target[global[corner]]; });
      };
      forEachBond(parts_[part], atTarget, [&](NodeIndex x, NodeIndex y) {
        if (gluedBy[x] == kNone && gluedBy[y] == kNone) {
          present.insert(pairKey(global[x], global[y]));
        } else if (gluedBy[x] != gluedBy[y]) {
          const std::uint32_t last = gluedBy[x] == kNone   ? gluedBy[y]
                                     : gluedBy[y] == kNone ? gluedBy[x]
                                                           : std::max(gluedBy[x], gluedBy[y]);
          glueBonds[last].push_back({global[x], global[y]});
        }
      });
    }
    for (std::size_t index = 0; index < glues_.size(); ++index)
      for (const Bond& bond : glueBonds[index])
        if (bond[0] == bond[1] || !present.insert(pairKey(bond[0], bond[1])).second)
          ++result_.reports[index].bondsDuplicate;
  }

  const std::vector<GluePart>& parts_;
  const std::vector<GlueSettings>& glues_;
  std::vector<NodeIndex> firstNode_, follow_;  ///< follow_: the node it was replaced by, or itself
  std::vector<Vec3> positions_;                ///< of the merged nodes
  GlueResult result_;
};

}  // namespace

sim::Result<GlueResult> glue(const std::vector<GluePart>& parts, const std::vector<GlueSettings>& glues) {
  return Gluer(parts, glues).run();
}

}  // namespace modeling
