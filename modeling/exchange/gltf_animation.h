#pragma once

#include <vector>

#include "modeling/exchange/gltf_file.h"
#include "modeling/exchange/rigid_fit.h"

namespace modeling {

/// The animations of a glTF file: "take" moves nodes and shows them while they are there, by a scale that
/// steps between 0 and 1, which every program knows. "visibility" says when a node is there once more, by
/// KHR_node_visibility and KHR_animation_pointer; it stands apart because programs that do not know the
/// latter may leave out a whole animation because of it (VTK), or take it for motion (assimp).
class GltfAnimation {
 public:
  /// `times`: of the frames, s. Keeps a reference to both.
  GltfAnimation(GltfFile& file, const std::vector<double>& times);

  /// The poses of a node, one a frame from `firstFrame`. Keys are left out as long as no point within
  /// `radius` (cm) of its origin is off by more than the tolerance (cm), half of it for positions, half for
  /// rotations. What stands still has no channel: the node has to stand where the first pose is.
  void move(std::size_t node, const std::vector<Pose>& poses, std::size_t firstFrame, double radius,
            double tolerance);

  /// Shows a node in these frames only, the last included. Not for a node that is there in all. The node
  /// becomes one with KHR_node_visibility, and of scale 0 where it is not there in the first frame, for who
  /// animates nothing.
  void show(std::size_t node, std::size_t firstFrame, std::size_t lastFrame);

  /// Adds the animations to the file, those that have channels.
  void finish();

 private:
  std::vector<float> timesOf(const std::vector<std::size_t>& keys, std::size_t firstFrame) const;
  static void addChannel(nlohmann::ordered_json& animation, const char* interpolation, std::size_t input,
                         std::size_t output, nlohmann::ordered_json target);

  GltfFile& file_;
  const std::vector<double>& times_;
  nlohmann::ordered_json take_, visibility_;
};

}  // namespace modeling
