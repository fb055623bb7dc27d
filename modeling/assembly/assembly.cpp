#include "modeling/assembly/assembly.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include "modeling/assembly/bond_sum.h"
#include "modeling/assembly/contributions.h"

namespace modeling {
namespace {

using sim::MaterialIndex;

/// The network's entry for a material in cells of one size. The first `materials.size()` entries are the
/// materials in order, whoever asks first.
class MaterialTable {
 public:
  explicit MaterialTable(const std::vector<Material>& materials)
      : materials_(materials), entries_(materials.size()), known_(materials.size(), 0) {}

  MaterialIndex find(std::size_t material, double cellSize) {
    sim::Material wanted = resolve(materials_[material], cellSize);
    if (!known_[material]) {
      known_[material] = 1;
      entries_[material] = std::move(wanted);
      return static_cast<MaterialIndex>(material);
    }
    if (entries_[material] == wanted) return static_cast<MaterialIndex>(material);
    const auto variants = entries_.begin() + std::ptrdiff_t(materials_.size());
    const auto found = std::find(variants, entries_.end(), wanted);
    const auto index = static_cast<MaterialIndex>(found - entries_.begin());
    if (found == entries_.end()) entries_.push_back(std::move(wanted));
    return index;
  }

  /// Those that nobody asked for are resolved for cells of 1 cm.
  std::vector<sim::Material> take() && {
    for (std::size_t material = 0; material < materials_.size(); ++material)
      if (!known_[material]) entries_[material] = resolve(materials_[material], 1.0);
    return std::move(entries_);
  }

 private:
  const std::vector<Material>& materials_;
  std::vector<sim::Material> entries_;
  std::vector<std::uint8_t> known_;
};

/// Nodes without mass, and the merged positions.
std::vector<sim::Blueprint::Node> placeNodes(const std::vector<AssemblyPart>& parts, const GlueResult& glue) {
  std::vector<sim::Blueprint::Node> nodes(glue.nodeCount);
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t i = 0; i < parts[p].lattice.nodes.size(); ++i) {
      if (!glue.gluedBy[p].empty() && glue.gluedBy[p][i] != sim::kNone) continue;
      sim::Blueprint::Node& node = nodes[glue.globalNode[p][i]];
      node.position = parts[p].lattice.nodes[i];
      node.velocity = parts[p].velocity;
      if (!parts[p].looseVelocities.empty()) node.velocity += parts[p].looseVelocities[i];
      node.part = static_cast<sim::PartIndex>(p);
    }
  return nodes;
}

void addUpMasses(const std::vector<AssemblyPart>& parts, const GlueResult& glue,
                 const std::vector<GivingCell>& cells, std::vector<sim::Blueprint::Node>& nodes) {
  for (const GivingCell& cell : cells)
    for (const NodeIndex node : cell.corners) nodes[node].mass += cell.mass;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t i = 0; i < glue.globalNode[p].size(); ++i) {
      double& mass = nodes[glue.globalNode[p][i]].mass;
      if (!parts[p].looseMasses.empty()) mass += parts[p].looseMasses[i];
      if (!parts[p].held.empty() && parts[p].held[i]) mass = std::numeric_limits<double>::infinity();
    }
}

sim::Status validateAll(const std::vector<Material>& materials) {
  for (std::size_t i = 0; i < materials.size(); ++i)
    if (auto status = validate(materials[i]); !status) {
      sim::Problem problem = status.problem();
      problem.place = "materials[" + std::to_string(i) + "]." + problem.place;
      return problem;
    }
  return sim::Done{};
}

sim::Result<std::vector<FittedPart>> fitParts(const std::vector<AssemblyPart>& parts,
                                              const std::vector<Material>& materials, const GlueResult& glue,
                                              const std::vector<Vec3>& positions) {
  std::vector<FittedPart> fitted;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    auto result = fitPart(parts[p], materials[parts[p].material], positions, glue, p);
    if (!result) return result.problem();
    fitted.push_back(std::move(result).value());
  }
  return fitted;
}

}  // namespace

sim::Result<sim::Blueprint> assemble(const std::vector<AssemblyPart>& parts,
                                     const std::vector<Material>& materials, const GlueResult& glue) {
  assert(glue.globalNode.size() == parts.size() && glue.gluedBy.size() == parts.size() &&
         glue.droppedCells.size() == parts.size() && glue.misshapen.size() == parts.size());
  if (auto status = validateAll(materials); !status) return status.problem();
  constexpr std::size_t kMost =
      std::numeric_limits<sim::PartIndex>::max() / 2;  // parts may double the materials
  if (parts.size() > kMost || materials.size() > kMost)
    return sim::Problem{"parts", "there are more than " + std::to_string(kMost) + " parts or materials",
                        "make one part of several"};

  sim::Blueprint blueprint;
  blueprint.nodes = placeNodes(parts, glue);
  std::vector<Vec3> positions;
  positions.reserve(blueprint.nodes.size());
  for (const auto& node : blueprint.nodes) positions.push_back(node.position);
  const auto fitted = fitParts(parts, materials, glue, positions);
  if (!fitted) return fitted.problem();

  MaterialTable table(materials);
  std::vector<PartConstants> constants;
  std::vector<GivingBond> looseBonds = givingBonds(parts, glue);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const Material& material = materials[parts[p].material];
    const double cellSize = fitted.value()[p].cellSize;
    constants.push_back(
        {table.find(parts[p].material, cellSize), material.youngsModulus, dampingTime(material, cellSize)});
    blueprint.partNames.push_back(parts[p].name);
  }
  for (GivingBond& loose : looseBonds)
    loose.bond.material = table.find(loose.bond.material, fitted.value()[loose.part].cellSize);

  const std::vector<GivingCell> cells = givingCells(parts, materials, fitted.value(), glue, positions);
  blueprint.bonds = addUpBonds(positions, cells, looseBonds, constants);
  addUpMasses(parts, glue, cells, blueprint.nodes);
  for (auto& node : blueprint.nodes) node.material = constants[node.part].material;
  std::size_t next = 0;
  for (const FittedPart& part : fitted.value())
    for (const std::uint8_t dropped : part.dropped) {
      if (!dropped) blueprint.cells.push_back(cells[next].corners);
      ++next;
    }
  blueprint.materials = std::move(table).take();
  return blueprint;
}

}  // namespace modeling
