#include "modeling/exchange/gltf_animation.h"

#include <string>
#include <utility>

#include "modeling/exchange/gltf_axes.h"
#include "modeling/exchange/key_reduction.h"

namespace modeling {

namespace {

using Json = nlohmann::ordered_json;

Json emptyAnimation(const char* name) {
  return {{"name", name}, {"channels", Json::array()}, {"samplers", Json::array()}};
}

}  // namespace

GltfAnimation::GltfAnimation(GltfFile& file, const std::vector<double>& times)
    : file_(file), times_(times), take_(emptyAnimation("take")), visibility_(emptyAnimation("visibility")) {}

std::vector<float> GltfAnimation::timesOf(const std::vector<std::size_t>& keys,
                                          std::size_t firstFrame) const {
  std::vector<float> times;
  times.reserve(keys.size());
  for (const std::size_t key : keys) times.push_back(static_cast<float>(times_[firstFrame + key]));
  return times;
}

void GltfAnimation::addChannel(Json& animation, const char* interpolation, std::size_t input,
                               std::size_t output, Json target) {
  Json channel = {{"sampler", animation["samplers"].size()}, {"target", std::move(target)}};
  animation["channels"].push_back(std::move(channel));
  Json sampler = {{"input", input}, {"interpolation", interpolation}, {"output", output}};
  animation["samplers"].push_back(std::move(sampler));
}

void GltfAnimation::move(std::size_t node, const std::vector<Pose>& poses, std::size_t firstFrame,
                         double radius, double tolerance) {
  const auto add = [&](const std::vector<std::size_t>& keys, const char* path, const auto& numbersOf) {
    if (keys.size() < 2) return;
    std::vector<float> values;
    for (const std::size_t key : keys) {
      const auto numbers = numbersOf(poses[key]);
      values.insert(values.end(), numbers.begin(), numbers.end());
    }
    addChannel(take_, "LINEAR", file_.addTimes(timesOf(keys, firstFrame)),
               file_.addValues(values, values.size() / keys.size()), {{"node", node}, {"path", path}});
  };
  add(positionKeys(poses, 0.5 * tolerance), "translation",
      [](const Pose& pose) { return inMetres(pose.position); });
  add(rotationKeys(poses, radius, 0.5 * tolerance), "rotation",
      [](const Pose& pose) { return upright(pose.rotation); });
}

void GltfAnimation::show(std::size_t node, std::size_t firstFrame, std::size_t lastFrame) {
  std::vector<std::size_t> keys{0};
  std::vector<bool> flags{firstFrame == 0};
  if (firstFrame > 0) {
    keys.push_back(firstFrame);
    flags.push_back(true);
  }
  if (lastFrame + 1 < times_.size()) {
    keys.push_back(lastFrame + 1);
    flags.push_back(false);
  }
  std::vector<float> scales;
  for (const bool flag : flags) scales.insert(scales.end(), 3, flag ? 1.0F : 0.0F);
  const std::size_t input = file_.addTimes(timesOf(keys, 0));
  addChannel(take_, "STEP", input, file_.addValues(scales, 3), {{"node", node}, {"path", "scale"}});
  const std::string pointer = "/nodes/" + std::to_string(node) + "/extensions/KHR_node_visibility/visible";
  addChannel(visibility_, "STEP", input, file_.addFlags(flags),
             {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}});
  Json& shown = file_.json()["nodes"][node];
  // Visible, as far as that goes, for who knows the one extension and not the other.
  shown["extensions"]["KHR_node_visibility"] = {{"visible", true}};
  // assimp squashes a node of which an animation has the scale and nobody states the rotation.
  if (!shown.contains("rotation")) shown["rotation"] = {0.0, 0.0, 0.0, 1.0};
  if (firstFrame > 0) shown["scale"] = {0.0, 0.0, 0.0};
}

void GltfAnimation::finish() {
  for (Json* animation : {&take_, &visibility_}) {
    if (!(*animation)["channels"].empty()) file_.append("animations", std::move(*animation));
  }
}

}  // namespace modeling
