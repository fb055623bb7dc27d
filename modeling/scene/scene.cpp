#include "modeling/scene/scene.h"

#include <string_view>

namespace modeling {
namespace {

constexpr std::string_view kColliderPrefix = "collider.";
constexpr std::string_view kPositionSuffix = ".position";
constexpr std::string_view kRotationSuffix = ".rotation";

struct ScaleTarget {
  std::string_view text;
  sim::TrackTarget target;
};
constexpr ScaleTarget kMaterialScales[] = {{"stiffness.scale", sim::TrackTarget::stiffnessScale},
                                           {"damping.scale", sim::TrackTarget::dampingScale}};

}  // namespace

std::optional<TargetName> TargetName::parse(std::string_view text) {
  using sim::TrackTarget;
  if (text == "gravity") return TargetName{TrackTarget::gravity, ""};
  if (text == "gravity.scale") return TargetName{TrackTarget::gravityScale, ""};
  for (const ScaleTarget& scale : kMaterialScales) {
    if (text == scale.text) return TargetName{scale.target, ""};
    if (text.starts_with(scale.text) && text.size() > scale.text.size() + 1 &&
        text[scale.text.size()] == '.') {
      return TargetName{scale.target, std::string(text.substr(scale.text.size() + 1))};
    }
  }
  if (!text.starts_with(kColliderPrefix)) return std::nullopt;
  text.remove_prefix(kColliderPrefix.size());
  for (const std::string_view suffix : {kPositionSuffix, kRotationSuffix}) {
    if (!text.ends_with(suffix) || text.size() == suffix.size()) continue;
    const auto target =
        suffix == kPositionSuffix ? TrackTarget::colliderPosition : TrackTarget::colliderRotation;
    return TargetName{target, std::string(text.substr(0, text.size() - suffix.size()))};
  }
  return std::nullopt;
}

std::string TargetName::text() const {
  using sim::TrackTarget;
  const std::string ofObject = object.empty() ? "" : "." + object;
  switch (target) {
    case TrackTarget::gravity:
      return "gravity";
    case TrackTarget::gravityScale:
      return "gravity.scale";
    case TrackTarget::stiffnessScale:
      return "stiffness.scale" + ofObject;
    case TrackTarget::dampingScale:
      return "damping.scale" + ofObject;
    case TrackTarget::colliderPosition:
      return "collider" + ofObject + std::string(kPositionSuffix);
    case TrackTarget::colliderRotation:
      return "collider" + ofObject + std::string(kRotationSuffix);
  }
  return "";
}

bool TargetName::isVector() const {
  return sim::isVector(target);
}

Scene::Scene() = default;
Scene::Scene(const Scene& other) = default;
Scene::Scene(Scene&& other) noexcept = default;
Scene& Scene::operator=(const Scene& other) = default;
Scene& Scene::operator=(Scene&& other) noexcept = default;
Scene::~Scene() = default;
bool Scene::operator==(const Scene& other) const = default;

}  // namespace modeling
