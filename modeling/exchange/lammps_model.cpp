#include "modeling/exchange/lammps_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "modeling/exchange/lammps_colliders.h"
#include "modeling/scene/scene_file.h"
#include "modeling/text/text_output.h"
#include "sim/methods/stable_step.h"

namespace modeling {

namespace {

double median(std::vector<double> numbers) {
  if (numbers.empty()) return 0.0;
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

/// Cuts the bonds of one class, by ascending threshold, into levels of equal number, each with its mean.
void addLevels(std::vector<sim::BondIndex> bonds, std::size_t levels, LammpsModel& model) {
  const sim::Network& network = *model.network;
  const auto threshold = [&](sim::BondIndex bond) { return static_cast<double>(network.thresholds[bond]); };
  std::sort(bonds.begin(), bonds.end(), [&](sim::BondIndex left, sim::BondIndex right) {
    return threshold(left) != threshold(right) ? threshold(left) < threshold(right) : left < right;
  });
  const sim::BondClass& of = network.bond(bonds.front());
  for (std::size_t level = 0; level < levels; ++level) {
    const std::size_t first = bonds.size() * level / levels;
    const std::size_t last = bonds.size() * (level + 1) / levels;
    if (first == last) continue;
    double mean = 0.0;
    for (std::size_t i = first; i < last; ++i)
      mean += threshold(bonds[i]) / static_cast<double>(last - first);
    for (std::size_t i = first; i < last; ++i) {
      model.typeOfBond[bonds[i]] = static_cast<std::uint32_t>(model.bondTypes.size());
      model.thresholdRounding = std::max(model.thresholdRounding, std::abs(threshold(bonds[i]) / mean - 1.0));
    }
    model.bondTypes.push_back({of.stiffness, of.restLength, of.damping, mean});
  }
}

/// Bonds whose constants agree to nine digits: below that is what sums of cells were rounded by.
using BondKind = std::array<std::int64_t, 3>;
using BondsOfKind = std::map<BondKind, std::vector<sim::BondIndex>>;

BondKind kindOf(const sim::BondClass& bond) {
  const auto rounded = [](double constant) {
    return constant > 0.0 ? std::llround(1e9 * std::log(constant)) : std::numeric_limits<std::int64_t>::min();
  };
  return {rounded(bond.stiffness), rounded(bond.restLength), rounded(bond.damping)};
}

void addBondTypes(LammpsModel& model) {
  const sim::Network& network = *model.network;
  BondsOfKind breakable, unbreakable;
  for (sim::BondIndex bond = 0; bond < network.bondCount(); ++bond) {
    auto& kinds = std::isfinite(network.thresholds[bond]) ? breakable : unbreakable;
    kinds[kindOf(network.bond(bond))].push_back(bond);
  }
  model.typeOfBond.resize(network.bondCount());
  for (const auto& [kind, bonds] : unbreakable) {
    const sim::BondClass& of = network.bond(bonds.front());
    for (const sim::BondIndex bond : bonds)
      model.typeOfBond[bond] = static_cast<std::uint32_t>(model.bondTypes.size());
    model.bondTypes.push_back({of.stiffness, of.restLength, of.damping, sim::kUnbreakable});
  }
  const std::size_t levels =
      std::clamp<std::size_t>(LammpsModel::kMostBreakingTypes / std::max<std::size_t>(1, breakable.size()), 1,
                              LammpsModel::kMostLevels);
  for (const auto& [kind, bonds] : breakable) {
    const double first = static_cast<double>(network.thresholds[bonds.front()]);
    const bool equal = std::all_of(bonds.begin(), bonds.end(), [&](sim::BondIndex bond) {
      return static_cast<double>(network.thresholds[bond]) == first;
    });
    addLevels(bonds, equal ? 1 : levels, model);
  }
}

/// What each node's bonds say of it.
void addNodeValues(LammpsModel& model) {
  const sim::Network& network = *model.network;
  model.contactStiffness.assign(network.nodeCount(), std::numeric_limits<double>::infinity());
  model.dampingTime.assign(network.nodeCount(), 0.0);
  std::vector<double> count(network.nodeCount(), 0.0);
  for (sim::NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (sim::BondIndex b = network.firstBond[a]; b < network.firstBond[a + 1]; ++b) {
      const sim::BondClass& bond = network.bond(b);
      model.longestBond = std::max(model.longestBond, bond.restLength);
      for (const sim::NodeIndex node : {a, network.bondEnds[b]}) {
        model.contactStiffness[node] = std::min(model.contactStiffness[node], bond.stiffness);
        model.dampingTime[node] += bond.damping / bond.stiffness;
        count[node] += 1.0;
      }
    }
  }
  for (std::size_t node = 0; node < network.nodeCount(); ++node) {
    if (!std::isfinite(model.contactStiffness[node])) model.contactStiffness[node] = 0.0;
    if (count[node] > 0.0) model.dampingTime[node] /= count[node];
  }
}

void addAtomTypes(LammpsModel& model) {
  const sim::Network& network = *model.network;
  std::map<std::pair<sim::MaterialIndex, bool>, std::vector<sim::NodeIndex>> kinds;
  for (sim::NodeIndex node = 0; node < network.nodeCount(); ++node)
    kinds[{network.nodeMaterials[node], !std::isfinite(network.masses[node])}].push_back(node);
  model.typeOfNode.resize(network.nodeCount());
  for (const auto& [kind, nodes] : kinds) {
    std::vector<double> radii, stiffnesses;
    for (const sim::NodeIndex node : nodes) {
      model.typeOfNode[node] = static_cast<std::uint32_t>(model.atomTypes.size());
      radii.push_back(static_cast<double>(network.radii[node]));
      stiffnesses.push_back(model.contactStiffness[node]);
    }
    model.atomTypes.push_back(
        {kind.first, kind.second, median(std::move(radii)), median(std::move(stiffnesses))});
  }
}

/// A frame is a whole number of steps.
void chooseStep(const Scene& scene, LammpsModel& model) {
  const double stable = sim::automaticStep(sim::measureSpectrum(*model.network), {},
                                           sim::Method::velocityVerlet, scene.solver.safety);
  const double frame = 1.0 / scene.output.fps;
  const double wanted = std::min(scene.solver.step.seconds.value_or(stable), frame);
  model.stepsPerFrame = static_cast<std::uint64_t>(std::ceil(frame / wanted * (1.0 - 1e-12)));
  model.step = frame / static_cast<double>(model.stepsPerFrame);
  const double left = std::max(0.0, scene.output.duration - model.moment->time);
  model.frames =
      std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(left * scene.output.fps)));
}

}  // namespace

sim::Result<LammpsModel> lammpsModel(const sim::TakeReader& take, const ExportRequest& request) {
  const auto text = take.sceneOf(request.firstFrame);
  if (!text) return text.problem();
  Scene scene;
  if (!text->empty()) {
    const auto file = parseScene(*text, "the take's scene");
    if (!file) return file.problem();
    scene = file->scene;
  }
  const auto moment = take.frame(request.firstFrame);
  if (!moment) return moment.problem();
  LammpsModel model;
  model.network = &take.network();
  model.moment = *moment;
  model.conditions = conditionsOf(scene, take.network().materials);
  addBondTypes(model);
  addNodeValues(model);
  addAtomTypes(model);
  chooseStep(scene, model);
  return model;
}

std::vector<std::string> lammpsDeviations(const LammpsModel& model) {
  std::vector<std::string> said;
  const bool breaks = std::any_of(model.bondTypes.begin(), model.bondTypes.end(),
                                  [](const LammpsBondType& type) { return std::isfinite(type.threshold); });
  said.push_back(
      "without the BPM package, bonds are damped as a whole at each node, by the change of its forces from "
      "step to "
      "step, not bond by bond");
  if (breaks) {
    said.push_back("thresholds are rounded to levels, by at most " +
                   std::to_string(100.0 * model.thresholdRounding) + " per cent");
    said.push_back(
        "without BPM, a node loses at most one bond in each search for broken bonds, and searches are some "
        "steps "
        "apart (see fix bond/break below)");
    said.push_back(
        "a broken bond takes no cell along, and does not push when its nodes come closer than it was long");
  }
  said.push_back(
      "nodes that no bond joins repel, of one fragment too, by a soft spring that is as stiff as ours at "
      "first touch; "
      "between nodes there is neither contact damping nor friction, and nodes that begin in contact push at "
      "once");
  for (const sim::Collider& collider : model.conditions.environment.colliders) {
    if (!hasLammpsFormulas(collider))
      said.push_back("the collider \"" + oneLine(collider.name) + "\" is left out: it is a " +
                     std::string(kindName(collider)));
    else if (collider.activeFrom > model.moment->time || std::isfinite(collider.activeUntil))
      said.push_back("the collider \"" + oneLine(collider.name) + "\" is there all the time");
  }
  if (!model.conditions.tracks.empty())
    said.push_back("tracks are left out: gravity, stiffness and colliders stay as they are without them");
  for (const sim::Material& material : model.network->materials) {
    if (std::isfinite(material.yieldStrain))
      said.push_back("the material \"" + oneLine(material.name) + "\" does not flow");
  }
  return said;
}

}  // namespace modeling
