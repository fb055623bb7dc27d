#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "modeling/scene/build_parts.h"
#include "modeling/scene/scene.h"

namespace ui {

/// Two nodes that are glued, or could be, where they are in the world before gluing.
struct GlueLink {
  modeling::NodeIndex a = 0;
  modeling::NodeIndex b = 0;
  modeling::Vec3 atA = modeling::Vec3::Zero();  ///< cm
  modeling::Vec3 atB = modeling::Vec3::Zero();  ///< cm

  double distance() const { return (atA - atB).norm(); }  ///< cm
};

/// What one gluing of a scene does.
struct GlueOutcome {
  modeling::Gluing gluing;
  std::vector<GlueLink> links;      ///< what is glued, in order of a
  std::vector<GlueLink> freed;      ///< in reach, but taken out by hand; with the nearest node of b
  modeling::GlueReport report;      ///< all zero where there is a problem
  std::optional<GlueLink> nearest;  ///< where nothing is in reach: the two nodes that are nearest
  std::optional<sim::Problem> problem;
};

/// Finds what gluings do, and keeps the lattices of the last time for as long as the parts stay the same, so
/// that only the first time costs as much as building them. Not thread-safe.
class GluePreviewer {
 public:
  /// Of gluing `index` of the scene, after those before it. Exactly what build() would glue.
  GlueOutcome outcome(const modeling::Scene& scene, std::size_t index, const std::filesystem::path& folder);

 private:
  std::optional<sim::Problem> prepare(const modeling::Scene& scene, const std::filesystem::path& folder);

  std::vector<modeling::Part> parts_;  ///< that built_ was built of
  std::filesystem::path folder_;
  std::optional<modeling::BuiltParts> built_;
  std::vector<modeling::GluePart> glueParts_;
};

}  // namespace ui
