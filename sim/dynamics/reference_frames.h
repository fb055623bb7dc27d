#pragma once

#include <vector>

#include "sim/base/bytes.h"
#include "sim/kernel/bond_kernel.h"
#include "sim/skipping/activity.h"
#include "sim/state/motion.h"

namespace sim {

/// The reference against which forces in float are computed (FloatReference in bond_kernel.h).
///
/// The shape of the reference is that of the network when it was made, about the centre of each of its
/// components, and never changes. What moves is a frame a fragment, fitted to the nodes from time to time:
/// forces are computed in the axes of the reference, so that a frame is all there is to take anew when a
/// fragment moves and turns. Displacements from a frame hold the deformation, and what the fragment moved
/// since the fit: in kStepsPerFit steps of a wave's travel from node to node that is about as many node
/// distances as its speed is of the speed of sound.
class ReferenceFrames {
 public:
  ReferenceFrames(const Network& network, const Components& components);

  static constexpr std::uint64_t kStepsPerFit = 16;

  /// Fragments were born: they have the frame they came from until the next fit.
  void noteBirths(const Components& components);
  /// Fits the frames of all fragments that deform.
  void fit(const NodeVectors& positions, const Activity& activity);

  /// What a kernel step may point to, until something here changes. Its displacements and velocities are
  /// scratch that the kernel writes: also those of the state it leads to, if wanted.
  FloatReference describe(const BondLayout& layout, bool displaceNext);

  /// The last step wrote the displacements of the state it led to, and nothing has moved since but what does
  /// not deform.
  bool displaced() const { return displaced_; }
  /// The state that the kernel's step led to is the one that the next step begins with.
  void noteStepped();
  /// Displacements are of another state than the one that the next step begins with.
  void forgetDisplacements() { displaced_ = false; }

  void save(ByteWriter& writer) const { writer.putVector(frames_); }
  /// False when it cannot have come from save() with so many fragments.
  static bool read(ByteReader& reader, std::size_t fragments, std::vector<ReferenceFrame>& frames);
  void restore(std::vector<ReferenceFrame> frames, const Components& components);
  std::size_t memoryBytes() const;

 private:
  struct Sums;

  void nameFrames(const Components& components);
  void sumUp(const NodeVectors& positions, std::span<const std::uint32_t> blocks,
             std::vector<Sums>& sums) const;
  Vec3 shapeAt(std::size_t node) const { return shape_.get(node) + remainder_.get(node); }

  FloatNodeVectors shape_;
  FloatNodeVectors remainder_;  ///< of the shape in double
  FloatNodeVectors displacement_;
  FloatNodeVectors velocity_;
  FloatNodeVectors nextDisplacement_;
  FloatNodeVectors nextVelocity_;
  std::vector<ReferenceFrame> frames_;
  std::vector<std::uint32_t> frameOfNode_;
  std::vector<std::uint8_t> mixed_;
  bool displaced_ = false;
};

}  // namespace sim
