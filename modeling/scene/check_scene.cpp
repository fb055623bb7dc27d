#include <algorithm>
#include <limits>

#include "modeling/scene/scene.h"
#include "modeling/scene/scene_ranges.h"
#include "modeling/text/spelling.h"

namespace modeling {
namespace {

using sim::Problem;
using MaybeProblem = std::optional<Problem>;
using Names = std::vector<std::string>;

std::string indexed(std::string_view list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

template <class Items>
Names namesOf(const Items& items) {
  Names names;
  for (const auto& item : items) names.push_back(item.name);
  return names;
}

bool knows(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Problem unknown(std::string place, std::string_view what, const std::string& name, const Names& names) {
  return {std::move(place), "there is no " + std::string(what) + " " + inQuotes(name),
          didYouMean(name, names)};
}

MaybeProblem checkNames(const std::string& list, const Names& names) {
  if (names.size() >= std::numeric_limits<std::uint16_t>::max()) {
    return Problem{list, "there are " + std::to_string(names.size()) + " of them",
                   "keep to fewer than 65535"};
  }
  Names sorted = names;
  std::sort(sorted.begin(), sorted.end());
  const auto repeated = std::adjacent_find(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string place = indexed(list, i);
    if (names[i].empty()) return Problem{place, "the name is empty", "give it a name"};
    const bool second = repeated != sorted.end() && names[i] == *repeated &&
                        std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
                            names.begin() + static_cast<std::ptrdiff_t>(i);
    if (second)
      return Problem{place + ".name", inQuotes(names[i]) + " is named twice", "rename one of the two"};
  }
  return std::nullopt;
}

MaybeProblem checkBox(const std::string& place, const Box& box) {
  if ((box.min.array() <= box.max.array()).all()) return std::nullopt;
  return Problem{place + ".max", "the box ends before it begins",
                 "let no number of max be below that of min"};
}

MaybeProblem checkPart(const std::string& place, const Part& part, const Names& materials) {
  const bool network = std::holds_alternative<NetworkShape>(part.shape);
  if (part.material.empty() && !network) {
    return Problem{place, "the part " + inQuotes(part.name) + " has no material", "add the key \"material\""};
  }
  if (!part.material.empty() && !knows(materials, part.material)) {
    return unknown(place + ".material", "material", part.material, materials);
  }
  for (std::size_t i = 0; i < part.hold.size(); ++i) {
    if (auto problem = checkBox(place + "." + indexed("hold", i), part.hold[i])) return problem;
  }
  return std::nullopt;
}

MaybeProblem checkGluing(const std::string& place, const Gluing& gluing, const Names& parts) {
  if (!knows(parts, gluing.a)) return unknown(place + ".a", "part", gluing.a, parts);
  if (!knows(parts, gluing.b)) return unknown(place + ".b", "part", gluing.b, parts);
  if (gluing.a == gluing.b) {
    return Problem{place + ".b", inQuotes(gluing.a) + " is glued to itself", "name two different parts"};
  }
  if (gluing.pairs.empty() && gluing.reach <= 0.0) {
    return Problem{place, "neither reach nor pairs are given", "add \"reach\" in cm"};
  }
  return gluing.region ? checkBox(place + ".region", *gluing.region) : std::nullopt;
}

MaybeProblem checkCollider(const std::string& place, const SceneCollider& collider) {
  if (const auto* obstacle = std::get_if<MeshObstacle>(&collider.form);
      obstacle != nullptr && obstacle->file.empty() && !obstacle->isRead())
    return Problem{place, "the collider " + inQuotes(collider.name) + " has no mesh", "add the key \"file\""};
  if (!collider.active || (*collider.active)[0] < (*collider.active)[1]) return std::nullopt;
  return Problem{place + ".active", "the collider " + inQuotes(collider.name) + " goes before it comes",
                 "give the later time last"};
}

MaybeProblem checkTarget(const std::string& place, const TargetName& target, const Names& materials,
                         const Names& colliders) {
  const bool ofCollider = sim::drivesCollider(target.target);
  if (ofCollider && !knows(colliders, target.object))
    return unknown(place, "collider", target.object, colliders);
  if (!ofCollider && !target.object.empty() && !knows(materials, target.object)) {
    return unknown(place, "material", target.object, materials);
  }
  return std::nullopt;
}

MaybeProblem checkKeys(const std::string& place, const SceneTrack& track) {
  if (track.keys.empty()) return Problem{place, "the track has no keys", "add one, such as [0, 1]"};
  const bool scale = !track.target.isVector();
  for (std::size_t i = 0; i < track.keys.size(); ++i) {
    const SceneTrackKey& key = track.keys[i];
    const std::string at = indexed(place, i);
    if (i > 0 && !(track.keys[i - 1].time < key.time)) {
      return Problem{at, "this key is not later than the one before", "put the keys in order of time"};
    }
    const double* number = std::get_if<double>(&key.value);
    if ((number != nullptr) != scale) {
      return Problem{at + "[1]", "this is the wrong kind of value for " + track.target.text(),
                     scale ? "give one number" : "give three numbers"};
    }
    const bool ofBonds = track.target.target != sim::TrackTarget::gravityScale;
    if (scale && ofBonds && *number < 0.0) {
      return Problem{at + "[1]", "a scale below 0 would make bonds push apart", "give at least 0"};
    }
  }
  return std::nullopt;
}

MaybeProblem firstProblem(const Scene& scene) {
  const Names materials = namesOf(scene.materials);
  const Names parts = namesOf(scene.parts);
  const Names colliders = namesOf(scene.environment.colliders);
  if (auto problem = numberOutOfRange(scene)) return problem;
  if (auto problem = checkNames("materials", materials)) return problem;
  if (auto problem = checkNames("parts", parts)) return problem;
  if (auto problem = checkNames("environment.colliders", colliders)) return problem;
  if (parts.empty()) return Problem{"parts", "there is nothing in this scene", "add a part"};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (auto problem = checkPart(indexed("parts", i), scene.parts[i], materials)) return problem;
  }
  for (std::size_t i = 0; i < scene.glue.size(); ++i) {
    if (auto problem = checkGluing(indexed("glue", i), scene.glue[i], parts)) return problem;
  }
  for (std::size_t i = 0; i < colliders.size(); ++i) {
    if (auto problem = checkCollider(indexed("environment.colliders", i), scene.environment.colliders[i]))
      return problem;
  }
  for (std::size_t i = 0; i < scene.tracks.size(); ++i) {
    const std::string place = indexed("tracks", i);
    const SceneTrack& track = scene.tracks[i];
    if (auto problem = checkTarget(place + ".target", track.target, materials, colliders)) return problem;
    if (auto problem = checkKeys(place + ".keys", track)) return problem;
  }
  if (auto status = checkPictureStyle(scene.view.picture); !status) return status.problem();
  return std::nullopt;
}

}  // namespace

sim::Status checkPictureStyle(const PictureStyle& style) {
  if (style.backdrop.kind == BackdropKind::environment && style.environment.image.empty()) {
    return Problem{"view.picture.backdrop.kind", "there is no image of the environment to be seen",
                   "name one in view.picture.environment.image"};
  }
  return sim::Done{};
}

sim::Status checkScene(const Scene& scene) {
  if (auto problem = firstProblem(scene)) return *problem;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const sim::Status status = validate(scene.materials[i].values);
    if (!status) {
      const Problem& problem = status.problem();
      return Problem{indexed("materials", i) + "." + problem.place, problem.what, problem.remedy};
    }
  }
  return sim::Done{};
}

}  // namespace modeling
