#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "modeling/material/material.h"
#include "modeling/scene/part.h"
#include "modeling/scene/picture_style.h"
#include "modeling/scene/scene_collider.h"
#include "sim/control/track.h"
#include "sim/state/settings.h"

/// The document: everything an artist edits, undoes and saves. Plain values; what they mean together is
/// checked by checkScene() and made into a simulation by build().
namespace modeling {

struct SceneMaterial {
  std::string name;
  std::string
      preset;       ///< of resources/materials; "": none. `values` has what it gives, overrides laid over it
  Material values;  ///< values.name == name

  bool operator==(const SceneMaterial&) const = default;
};

/// Glues part `a` to part `b` (modeling/glue/glue.h).
struct Gluing {
  std::string a;
  std::string b;
  double reach = 0.0;                                ///< cm; not read where pairs are given
  std::vector<std::array<sim::NodeIndex, 2>> pairs;  ///< node of a, node of b
  std::vector<sim::NodeIndex> exclude;               ///< nodes of a that stay free
  std::optional<Box> region;  ///< coordinates of part a: only its nodes inside are glued

  bool operator==(const Gluing&) const = default;
};

struct SceneEnvironment {
  Vec3 gravity = sim::Environment{}.gravity;  ///< cm/s^2
  std::vector<SceneCollider> colliders;

  bool operator==(const SceneEnvironment&) const = default;
};

/// What a track drives, written "gravity.scale", "gravity", "stiffness.scale[.MATERIAL]",
/// "damping.scale[.MATERIAL]", "collider.NAME.position" or "collider.NAME.rotation".
struct TargetName {
  sim::TrackTarget target = sim::TrackTarget::gravityScale;
  std::string object;  ///< of a material or collider; "": all materials, or no object

  /// Nothing for a text of another form.
  static std::optional<TargetName> parse(std::string_view text);
  std::string text() const;
  bool isVector() const;
  bool operator==(const TargetName&) const = default;
};

struct SceneTrackKey {
  double time = 0.0;                       ///< s
  std::variant<double, Vec3> value = 0.0;  ///< a colliderRotation is a rotation vector in degrees

  bool operator==(const SceneTrackKey&) const = default;
};

struct SceneTrack {
  TargetName target;
  std::vector<SceneTrackKey> keys;  ///< at least one, times ascending
  sim::Interpolation interpolation = sim::Interpolation::linear;

  bool operator==(const SceneTrack&) const = default;
};

struct Contact {
  sim::ContactKind kind = sim::ContactSettings{}.kind;
  bool between = sim::ContactSettings{}.between;
  bool self = sim::ContactSettings{}.self;
  sim::ContactLength length = sim::ContactSettings{}.length;
  double stiffnessScale = sim::ContactSettings{}.stiffnessScale;
  double dampingRatio = sim::ContactSettings{}.dampingRatio;
  double friction = sim::ContactSettings{}.friction;

  bool operator==(const Contact&) const = default;
};

struct Step {
  std::optional<double> seconds;    ///< > 0; absent, written "auto": automatic and stable
  std::optional<double> tolerance;  ///< of strain: the automatic step, shortened to keep to it

  bool operator==(const Step&) const = default;
};

struct Solver {
  sim::Method method = sim::Settings{}.method;
  Step step;
  double safety = sim::Settings{}.safety;
  Contact contact;
  sim::SkipSettings skip;
  std::uint64_t seed = sim::Settings{}.seed;

  bool operator==(const Solver&) const = default;
};

struct Output {
  double fps = 24.0;
  double duration = 2.0;  ///< s

  bool operator==(const Output&) const = default;
};

/// Copied and destroyed in scene.cpp: in each of the sources that pass scenes on, that code took a second to
/// compile.
struct Scene {
  Scene();
  Scene(const Scene& other);
  Scene(Scene&& other) noexcept;
  Scene& operator=(const Scene& other);
  Scene& operator=(Scene&& other) noexcept;
  ~Scene();

  std::string name;
  std::vector<SceneMaterial> materials;  ///< names differ
  std::vector<Part> parts;               ///< names differ
  std::vector<Gluing> glue;              ///< done in this order
  SceneEnvironment environment;          ///< names of colliders differ
  std::vector<SceneTrack> tracks;
  Solver solver;
  Output output;
  View view;

  bool operator==(const Scene& other) const;
};

/// What makes the scene impossible though each value by itself is possible: names given twice or to nothing,
/// keys of a track out of order... The Problem's place is a path, such as "parts[2].material". Looks at no
/// file.
sim::Status checkScene(const Scene& scene);
}  // namespace modeling
