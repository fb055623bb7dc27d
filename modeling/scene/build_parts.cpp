#include "modeling/scene/build_parts.h"

#include <algorithm>
#include <map>
#include <sstream>

#include "modeling/import/lammps_data.h"
#include "modeling/import/mesh_file.h"
#include "modeling/shapes/mesh_lattice.h"
#include "modeling/shapes/quality.h"
#include "modeling/shapes/resolution.h"
#include "modeling/text/dimension.h"
#include "modeling/text/spelling.h"

namespace modeling {
namespace {

using sim::Problem;

std::string placeOf(std::size_t part) {
  return "parts[" + std::to_string(part) + "]";
}

/// Shapes name the key within themselves; the scene's reader needs the way to the part, too.
Problem within(std::size_t part, const Problem& problem) {
  const std::string key = problem.place.empty() ? "" : "." + problem.place;
  return {placeOf(part) + key, problem.what, problem.remedy};
}

/// FILE:LINE:COLUMN says enough by itself.
bool hasLine(const Problem& problem) {
  return std::count(problem.place.begin(), problem.place.end(), ':') >= 2;
}

std::vector<std::uint8_t> heldNodes(const std::vector<Box>& regions, const std::vector<Vec3>& nodes) {
  std::vector<std::uint8_t> held(regions.empty() ? 0 : nodes.size(), 0);
  for (const Box& box : regions) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const bool inside =
          (box.min.array() <= nodes[i].array()).all() && (nodes[i].array() <= box.max.array()).all();
      if (inside) held[i] = 1;
    }
  }
  return held;
}

/// Mass of each node as a share of an unknown density (cells) or in g (raw network): enough to find the
/// centre.
std::vector<double> nodeShares(const AssemblyPart& part) {
  std::vector<double> shares = part.looseMasses;
  shares.resize(part.lattice.nodes.size(), 0.0);
  for (const sim::CellCorners& cell : part.lattice.cells) {
    const double share = cellVolume(cornerPositions(part.lattice.nodes, cell)) / 8.0;
    for (const sim::NodeIndex corner : cell) shares[corner] += share;
  }
  return shares;
}

/// Adds the velocity of turning about the centre of mass, so that spinning gives the part no push.
void spin(const Vec3& angularVelocity, AssemblyPart& part) {
  if (angularVelocity == Vec3::Zero()) return;
  const std::vector<double> shares = nodeShares(part);
  Vec3 centre = Vec3::Zero();
  double sum = 0.0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    centre += shares[i] * part.lattice.nodes[i];
    sum += shares[i];
  }
  centre /= sum;
  part.looseVelocities.resize(shares.size(), Vec3::Zero());
  for (std::size_t i = 0; i < shares.size(); ++i) {
    part.looseVelocities[i] += angularVelocity.cross(part.lattice.nodes[i] - centre);
  }
}

/// No node may be farther from the origin on any axis, cm: there, neighbours of a micrometre are still told
/// apart.
constexpr double kFarthest = 2.0 * reachOf(Dimension::length);

/// Below this share of a mesh's volume, walls must have been lost.
constexpr double kMostOfIt = 0.95;

std::string remarkOn(const std::string& part, const MeshShape& shape, const MeshFit& fit) {
  std::ostringstream words;
  words.precision(3);
  words << "the cells of " << inQuotes(part) << " have " << 100.0 * fit.volumeShare
        << " per cent of the mesh's volume and end within " << fit.farthest << " cm of its surface";
  if (fit.onceShare < 1.0) words << ", what is inside it more than once counted once";
  if (fit.volumeShare < kMostOfIt)
    words << "; what is thinner than a cell is lost: cells of " << 0.5 * shape.cellSize
          << " cm would hold more";
  const auto& crossings = fit.crossings;
  if (crossings.triangles > 0)
    words << "; the mesh passes through itself (" << crossings.triangles << " of its faces, the first near ("
          << crossings.first.x() << ", " << crossings.first.y() << ", " << crossings.first.z()
          << ") cm); its bodies are filled as one, and fit better when they are united before exporting it";
  return words.str();
}

class PartBuilder {
 public:
  PartBuilder(const Scene& scene, const std::filesystem::path& folder, const Attendance& attendance)
      : scene_(scene), folder_(folder), attendance_(attendance) {
    for (const SceneMaterial& material : scene.materials) built_.materials.push_back(material.values);
  }

  sim::Result<BuiltParts> run() {
    std::size_t nodes = 0;
    for (std::size_t i = 0; i < scene_.parts.size(); ++i) {
      const sim::Status status = add(i);
      if (!status) return status.problem();
      nodes += built_.parts.back().lattice.nodes.size();
      if (nodes > kMaxLatticeNodes) {
        return Problem{
            placeOf(i), "with this part there are " + std::to_string(nodes) + " nodes",
            "use larger cells; at most " + std::to_string(kMaxLatticeNodes) + " nodes are allowed"};
      }
    }
    return std::move(built_);
  }

 private:
  sim::Status add(std::size_t index) {
    const Part& part = scene_.parts[index];
    AssemblyPart made;
    made.name = part.name;
    made.velocity = part.velocity;
    const sim::Status status =
        std::visit([&](const auto& shape) { return shapeInto(shape, index, made); }, part.shape);
    if (!status) return status;
    if (!part.hold.empty() &&
        std::find(made.held.begin(), made.held.end(), std::uint8_t{1}) == made.held.end()) {
      return Problem{placeOf(index) + ".hold", "these regions hold no node of " + inQuotes(part.name),
                     "state them in the part's own coordinates"};
    }
    spin(part.angularVelocity, made);
    built_.parts.push_back(std::move(made));
    return sim::Done{};
  }

  template <class Shape>
  sim::Status shapeInto(const Shape& shape, std::size_t index, AssemblyPart& made) {
    sim::Result<Lattice> lattice = build(shape);
    if (!lattice) return within(index, lattice.problem());
    made.lattice = std::move(lattice).value();
    made.material = materialIndex(scene_.parts[index].material);
    return place(index, made);
  }

  sim::Status shapeInto(const MeshShape& shape, std::size_t index, AssemblyPart& made) {
    const auto file = loadMesh(folder_, shape.source(), attendance_);
    if (!file) return within(index, {"file", file.problem().what, file.problem().remedy});
    MeshFit fit;
    sim::Result<Lattice> lattice = fillMesh(file->mesh, shape.cellSize, fit);
    // How the file was taken may be what is wrong.
    if (!lattice)
      return within(index, {lattice.problem().place, lattice.problem().what + " (" + file->remark + ")",
                            lattice.problem().remedy});
    built_.remarks.push_back(file->remark);
    built_.remarks.push_back(remarkOn(made.name, shape, fit));
    made.lattice = std::move(lattice).value();
    made.material = materialIndex(scene_.parts[index].material);
    return place(index, made);
  }

  sim::Status shapeInto(const NetworkShape& shape, std::size_t index, AssemblyPart& made) {
    const std::filesystem::path file = folder_ / shape.file;
    sim::Result<LammpsData> data = loadLammpsData(file);
    if (!data)
      return hasLine(data.problem())
                 ? data.problem()
                 : within(index, {"file", shape.file + ": " + data.problem().what, data.problem().remedy});
    for (const std::string& note : data->notes) built_.remarks.push_back(inQuotes(made.name) + ": " + note);
    made.lattice.nodes = std::move(data->positions);
    made.looseMasses = std::move(data->masses);
    if (!data->velocities.empty()) made.looseVelocities = std::move(data->velocities);
    if (const sim::Status placed = place(index, made); !placed) return placed;
    return addBonds(shape, index, file.string(), data->bonds, made);
  }

  sim::Status addBonds(const NetworkShape& shape, std::size_t index, const std::string& file,
                       const std::vector<LammpsBond>& bonds, AssemblyPart& made) {
    std::map<int, std::pair<const BondType*, std::size_t>> types;
    made.material = baseMaterial(index);
    std::vector<std::string> known;
    for (const NamedBondType& type : shape.bondTypes) {
      known.push_back(type.type);
      types[std::stoi(type.type)] = {&type.constants, bondMaterial(made.material, type.constants)};
    }
    for (const LammpsBond& bond : bonds) {
      const auto found = types.find(bond.type);
      if (found == types.end()) {
        const std::string type = std::to_string(bond.type);
        return Problem{file + ':' + std::to_string(bond.line) + ":1",
                       "the scene's bondTypes do not have the type " + type + " of this bond",
                       "add \"" + type + "\" to bondTypes of the part " + inQuotes(made.name)};
      }
      const auto& [constants, material] = found->second;
      const double length = (made.lattice.nodes[bond.a] - made.lattice.nodes[bond.b]).norm();
      made.looseBonds.push_back({bond.a, bond.b, constants->stiffness, constants->restLength.value_or(length),
                                 constants->damping, static_cast<sim::MaterialIndex>(material)});
    }
    return sim::Done{};
  }

  sim::Status place(std::size_t index, AssemblyPart& made) {
    const Part& part = scene_.parts[index];
    made.held = heldNodes(part.hold, made.lattice.nodes);
    const Eigen::Affine3d worldFromPart = part.worldFromPart.worldFromPart();
    for (Vec3& node : made.lattice.nodes) node = worldFromPart * node;
    const Eigen::Quaterniond turn = part.worldFromPart.rotation.quaternion();
    for (Vec3& velocity : made.looseVelocities) velocity = turn * velocity;
    const auto isFar = [](const Vec3& node) { return !(node.cwiseAbs().maxCoeff() <= kFarthest); };
    if (std::any_of(made.lattice.nodes.begin(), made.lattice.nodes.end(), isFar)) {
      return Problem{placeOf(index) + ".worldFromPart",
                     inQuotes(part.name) + " reaches farther than " +
                         std::to_string(static_cast<int>(kFarthest)) + " cm from the middle of the world",
                     "scale it down, or put it nearer"};
    }
    return sim::Done{};
  }

  std::size_t materialIndex(const std::string& name) const {
    const auto found = std::find_if(scene_.materials.begin(), scene_.materials.end(),
                                    [&](const SceneMaterial& material) { return material.name == name; });
    return static_cast<std::size_t>(found - scene_.materials.begin());
  }

  /// A network without a material gets an unbreakable one of the part's name.
  std::size_t baseMaterial(std::size_t index) {
    const Part& part = scene_.parts[index];
    if (!part.material.empty()) return materialIndex(part.material);
    Material& material = built_.materials.emplace_back();
    material.name = part.name;
    return built_.materials.size() - 1;
  }

  /// The base material with the bond type's way to break.
  std::size_t bondMaterial(std::size_t base, const BondType& constants) {
    Material material = built_.materials[base];
    material.threshold.mean = constants.threshold;
    material.strength.reset();
    material.fractureToughness.reset();
    built_.materials.push_back(std::move(material));
    return built_.materials.size() - 1;
  }

  const Scene& scene_;
  const std::filesystem::path& folder_;
  const Attendance& attendance_;
  BuiltParts built_;
};

/// The region is a box in part a's own coordinates, so that a glue means the same wherever the part is put.
void excludeOutside(const Box& region, const Part& a, const std::vector<Vec3>& worldNodes,
                    std::vector<NodeIndex>& excluded) {
  const Eigen::AlignedBox3d box(region.min, region.max);
  const Eigen::Affine3d partFromWorld = a.worldFromPart.worldFromPart().inverse();
  for (NodeIndex node = 0; node < worldNodes.size(); ++node) {
    if (!box.contains(Vec3(partFromWorld * worldNodes[node]))) excluded.push_back(node);
  }
}

std::size_t partIndex(const Scene& scene, const std::string& name) {
  const auto found = std::find_if(scene.parts.begin(), scene.parts.end(),
                                  [&](const Part& part) { return part.name == name; });
  return static_cast<std::size_t>(found - scene.parts.begin());
}

}  // namespace

sim::Result<BuiltParts> buildParts(const Scene& scene, const std::filesystem::path& folder,
                                   const Attendance& attendance) {
  return PartBuilder(scene, folder, attendance).run();
}

std::vector<GlueSettings> glueSettings(const Scene& scene, const std::vector<AssemblyPart>& parts) {
  std::vector<GlueSettings> result;
  for (const Gluing& gluing : scene.glue) {
    GlueSettings& settings = result.emplace_back();
    settings.a = partIndex(scene, gluing.a);
    settings.b = partIndex(scene, gluing.b);
    settings.reach = gluing.reach;
    for (const auto& pair : gluing.pairs) settings.explicitPairs.push_back({pair[0], pair[1], 0.0});
    settings.excludedNodes = gluing.exclude;
    if (gluing.region) {
      excludeOutside(*gluing.region, scene.parts[settings.a], parts[settings.a].lattice.nodes,
                     settings.excludedNodes);
    }
  }
  return result;
}

std::vector<GluePart> glueParts(const std::vector<AssemblyPart>& parts) {
  std::vector<GluePart> result;
  for (const AssemblyPart& part : parts) {
    GluePart& glued = result.emplace_back(GluePart{part.name, part.lattice.nodes, part.lattice.cells, {}});
    for (const sim::BlueprintBond& bond : part.looseBonds) glued.looseBonds.push_back({bond.a, bond.b});
  }
  return result;
}

}  // namespace modeling
