#include "modeling/assembly/contributions.h"

#include <algorithm>
#include <cmath>

namespace modeling {
namespace {

std::uint32_t gluedBy(const GlueResult& glue, std::size_t part, NodeIndex node) {
  return glue.gluedBy[part].empty() ? sim::kNone : glue.gluedBy[part][node];
}

bool bothGluedAtOnce(const GlueResult& glue, std::size_t part, NodeIndex a, NodeIndex b) {
  const std::uint32_t gluing = gluedBy(glue, part, a);
  return gluing != sim::kNone && gluing == gluedBy(glue, part, b);
}

std::string partPlace(std::size_t index) {
  return "parts[" + std::to_string(index) + "]";
}

/// The part's nodes as merged, and behind them, where cells are fitted as they were before, as those were.
std::vector<Vec3> fittingPositions(const AssemblyPart& part, const std::vector<Vec3>& mergedPositions,
                                   const std::vector<NodeIndex>& globalNode, bool anyAsBefore) {
  std::vector<Vec3> positions;
  positions.reserve(part.lattice.nodes.size() * (anyAsBefore ? 2 : 1));
  for (const NodeIndex node : globalNode) positions.push_back(mergedPositions[node]);
  if (anyAsBefore) positions.insert(positions.end(), part.lattice.nodes.begin(), part.lattice.nodes.end());
  return positions;
}

double meanBond(const std::vector<sim::BlueprintBond>& bonds) {
  double sum = 0.0;
  for (const auto& bond : bonds) sum += bond.restLength;
  return bonds.empty() ? 1.0 : sum / double(bonds.size());
}

sim::Status checkLooseBonds(const AssemblyPart& part, std::size_t index) {
  std::vector<std::pair<NodeIndex, NodeIndex>> pairs;
  pairs.reserve(part.looseBonds.size());
  for (const auto& bond : part.looseBonds) pairs.push_back(std::minmax(bond.a, bond.b));
  std::sort(pairs.begin(), pairs.end());
  const auto twice = std::adjacent_find(pairs.begin(), pairs.end());
  if (twice == pairs.end()) return sim::Done{};
  return sim::Problem{partPlace(index),
                      "two bonds join nodes " + std::to_string(twice->first) + " and " +
                          std::to_string(twice->second) + " (counted from 0)",
                      "keep one of them"};
}

}  // namespace

sim::Result<FittedPart> fitPart(const AssemblyPart& part, const Material& material,
                                const std::vector<Vec3>& mergedPositions, const GlueResult& glue,
                                std::size_t index) {
  if (auto status = checkLooseBonds(part, index); !status) return status.problem();
  FittedPart fitted;
  fitted.dropped.assign(part.lattice.cells.size(), 0);
  for (const sim::CellIndex cell : glue.droppedCells[index]) fitted.dropped[cell] = 1;
  fitted.asBefore = fitted.dropped;
  for (const sim::CellIndex cell : glue.misshapen[index]) fitted.asBefore[cell] = 1;

  const bool anyAsBefore = !glue.droppedCells[index].empty() || !glue.misshapen[index].empty();
  const std::vector<Vec3> positions =
      fittingPositions(part, mergedPositions, glue.globalNode[index], anyAsBefore);
  std::vector<sim::CellCorners> cells = part.lattice.cells;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    if (!fitted.asBefore[cell]) continue;
    for (NodeIndex& node : cells[cell]) node += static_cast<NodeIndex>(part.lattice.nodes.size());
  }
  fitted.fit = fitBonds(positions, cells, material.pattern);
  double volume = 0.0;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    if (!(fitted.fit.ofCell(cell).volume > 0.0))
      return sim::Problem{partPlace(index), "cell " + std::to_string(cell) + " is turned inside out",
                          "use more or fewer cells, or glue with less reach"};
    volume += fitted.fit.ofCell(cell).volume;
  }
  fitted.cellSize = cells.empty() ? meanBond(part.looseBonds) : std::cbrt(volume / double(cells.size()));
  return fitted;
}

std::vector<GivingCell> givingCells(const std::vector<AssemblyPart>& parts,
                                    const std::vector<Material>& materials,
                                    const std::vector<FittedPart>& fitted, const GlueResult& glue,
                                    const std::vector<Vec3>& mergedPositions) {
  std::vector<GivingCell> giving;
  std::size_t count = 0;
  for (const auto& part : parts) count += part.lattice.cells.size();
  giving.reserve(count);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const auto& cells = parts[p].lattice.cells;
    const double density = materials[parts[p].material].density;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      GivingCell cell;
      cell.part = static_cast<std::uint32_t>(p);
      cell.shape = &fitted[p].fit.ofCell(c);
      for (std::size_t i = 0; i < 8; ++i) cell.corners[i] = glue.globalNode[p][cells[c][i]];
      for (std::size_t pair = 0; pair < kPairsPerCell; ++pair) {
        const CornerPair& ends = kCornerPairs[pair];
        if (cell.shape->stiffness[pair] > 0.0 && cell.corners[ends.a] != cell.corners[ends.b] &&
            !bothGluedAtOnce(glue, p, cells[c][ends.a], cells[c][ends.b]))
          cell.bonds |= 1U << pair;
      }
      double volume = cell.shape->volume;
      if (fitted[p].asBefore[c])  // with no bond left it only repeats what the other part has
        volume =
            cell.bonds == 0 ? 0.0 : std::max(0.0, cellVolume(cornerPositions(mergedPositions, cell.corners)));
      cell.mass = density * volume / 8.0;
      giving.push_back(cell);
    }
  }
  return giving;
}

std::vector<GivingBond> givingBonds(const std::vector<AssemblyPart>& parts, const GlueResult& glue) {
  std::vector<GivingBond> giving;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (const sim::BlueprintBond& bond : parts[p].looseBonds) {
      if (bothGluedAtOnce(glue, p, bond.a, bond.b)) continue;
      GivingBond merged{bond, static_cast<std::uint32_t>(p)};
      const auto [first, second] = std::minmax(glue.globalNode[p][bond.a], glue.globalNode[p][bond.b]);
      merged.bond.a = first;
      merged.bond.b = second;
      if (first != second) giving.push_back(merged);
    }
  std::stable_sort(giving.begin(), giving.end(),
                   [](const GivingBond& x, const GivingBond& y) { return x.bond.a < y.bond.a; });
  return giving;
}

}  // namespace modeling
