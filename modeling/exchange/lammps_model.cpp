#include "modeling/exchange/lammps_model.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "modeling/exchange/lammps_colliders.h"
#include "modeling/scene/scene_file.h"
#include "modeling/text/text_output.h"
#include "sim/methods/stable_step.h"

namespace modeling {

namespace {

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
  addAtomTypes(model);
  chooseStep(scene, model);
  model.firstStep = request.firstFrame * model.stepsPerFrame;
  return model;
}

namespace {

std::string ofThresholds(const ThresholdRounding& rounding) {
  std::ostringstream words;
  words.precision(3);
  words << "thresholds are within " << 100.0 * rounding.largest << " per cent of ours, their spread is "
        << rounding.spreadThere << ", ours " << rounding.spread << "; with BPM they are within "
        << 100.0 * rounding.largestOfLevels << " per cent";
  return words.str();
}

void addBreaking(const LammpsModel& model, std::vector<std::string>& said) {
  said.push_back(ofThresholds(model.rounding));
  std::string pulling = "without BPM, a bond that breaks goes on pulling for a few steps, at most ";
  said.push_back(pulling.append(std::to_string(LammpsModel::kStepsBetweenLists)));
  said.emplace_back(
      "with BPM, bonds break by compression too, and are at rest as long as they are at the start");
  said.emplace_back(
      "a broken bond takes no cell along, and does not push when its nodes come closer than it was long");
}

void addColliders(const LammpsModel& model, std::vector<std::string>& said) {
  for (const sim::Collider& collider : model.conditions.environment.colliders) {
    if (!hasLammpsFormulas(collider))
      said.emplace_back("the collider \"" + oneLine(collider.name) + "\" is left out: it is a " +
                        std::string(kindName(collider)));
    else if (collider.activeFrom > model.moment->time || std::isfinite(collider.activeUntil))
      said.emplace_back("the collider \"" + oneLine(collider.name) + "\" is there all the time");
    const auto isInside = [&](const sim::Vec3& position) {
      return sim::intrusion(collider, position).depth > 0.0;
    };
    if (hasLammpsFormulas(collider) && std::ranges::any_of(model.moment->positions, isInside))
      said.emplace_back("what begins inside the collider \"" + oneLine(collider.name) +
                        "\" is thrown out of it, not let out slowly");
  }
}

}  // namespace

std::vector<std::string> lammpsDeviations(const LammpsModel& model) {
  std::vector<std::string> said;
  said.emplace_back(
      "without the BPM package, bonds are damped as a whole at each node, by the change of its forces from "
      "step to step, not bond by bond");
  if (model.breaks()) addBreaking(model, said);
  said.emplace_back(
      "nodes meet nodes, whatever solver.contact.kind says: those that no bond joins repel, of one fragment "
      "too, by a soft spring that is as stiff as ours at "
      "first touch; between nodes there is neither contact damping nor friction, and nodes that begin in "
      "contact stay as large as they are apart then");
  const auto isRough = [](const sim::Collider& collider) { return collider.friction > 0.0; };
  if (model.conditions.settings.contact.kind == sim::ContactKind::surfaces &&
      std::ranges::any_of(model.conditions.environment.colliders, isRough))
    said.emplace_back(
        "friction at colliders opposes the speed of what slides, as with solver.contact.kind nodes: what "
        "rests "
        "on a slope creeps");
  addColliders(model, said);
  if (!model.conditions.tracks.empty())
    said.emplace_back("tracks are left out: gravity, stiffness and colliders stay as they are without them");
  for (const sim::Material& material : model.network->materials) {
    if (std::isfinite(material.yieldStrain))
      said.emplace_back("the material \"" + oneLine(material.name) + "\" does not flow");
  }
  return said;
}

}  // namespace modeling
