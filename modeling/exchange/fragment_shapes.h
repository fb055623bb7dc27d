#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "modeling/exchange/fragment_motion.h"
#include "modeling/exchange/part_parameters.h"
#include "sim/surface/surface_mesh.h"

namespace modeling {

/// Faces of one material on one side: outside (false), or bared by breaking.
using MaterialSide = std::pair<sim::MaterialIndex, bool>;

/// Equal bytes, equal numbers: for looking up what is compared exactly.
template <class Numbers>
struct HashOfBytes {
  std::size_t operator()(const Numbers& numbers) const {
    return std::hash<std::string_view>()(
        {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(numbers[0])});
  }
};

/// A vertex in glTF's units and axes (m, y up): three numbers of its position, three of its normal, two
/// texture coordinates and damage.
using ShapeVertex = std::array<float, 9>;

/// A triangle of a fragment, and in which of its shapes it is seen.
struct ShapeTriangle {
  std::array<std::uint32_t, 3> vertices{};  ///< of the fragment
  std::size_t firstShape = 0;
  std::size_t lastShape = 0;
};

/// How long a fragment looks the same. Frames are counted from the first exported one.
struct ShapeFrames {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// All that a fragment looks like from its birth on: shapes, each of which closes it. What they have in
/// common is there once.
class ShapedFragment {
 public:
  /// Begins a shape, which is added to from then on.
  void begin(std::size_t frame);
  void add(const MaterialSide& side, const std::array<ShapeVertex, 3>& corners);
  /// Nothing more is added to the shape.
  void end();
  /// The newest shape is still what is seen in this frame.
  void goOn(std::size_t frame) { shapes_.back().last = frame; }

  const std::vector<ShapeFrames>& shapes() const { return shapes_; }
  const std::vector<ShapeVertex>& vertices() const { return vertices_; }  ///< about the fragment's origin
  const std::map<MaterialSide, std::vector<ShapeTriangle>>& triangles() const { return triangles_; }

 private:
  using Corners = std::array<std::uint32_t, 3>;
  using Newest = std::unordered_map<Corners, std::size_t, HashOfBytes<Corners>>;
  std::uint32_t numberOf(const ShapeVertex& vertex);

  std::vector<ShapeFrames> shapes_;
  std::vector<ShapeVertex> vertices_;
  std::unordered_map<ShapeVertex, std::uint32_t, HashOfBytes<ShapeVertex>> known_;
  std::map<MaterialSide, std::vector<ShapeTriangle>> triangles_;
  std::map<MaterialSide, Newest> newest_;  ///< places of the triangles of the newest shape
};

/// The surfaces of fragments, where the nodes are in the first exported frame, as they change from frame to
/// frame: nothing of what breaks later is seen in them. Rounded as pictures draw them.
class FragmentShapes {
 public:
  /// Keeps references to all.
  FragmentShapes(const sim::Network& network, const sim::Snapshot& first, sim::LooseNodes looseNodes,
                 const std::optional<PartParameters>& parameters);

  /// The next frame, beginning with the first. Its fragments have been followed.
  void follow(const sim::BrokenPointer& broken, const FragmentFollower& followed);

  /// By fragment; those of which nothing is ever seen are not among them.
  const std::map<sim::FragmentId, ShapedFragment>& fragments() const { return fragments_; }
  /// Whether vertices have texture coordinates.
  bool haveCoordinates() const { return parameters_.has_value(); }
  /// How thick the walls of the bodies are that a material is in, cm: twice volume over surface, which is
  /// right for a plate.
  double thicknessOf(sim::MaterialIndex material) const;

 private:
  /// A fragment looks otherwise when its volume at rest has changed by more than this share, or when its
  /// marks have: its nodes, and where the material of others is given to it, its faces and their corners at
  /// rest. That a crack beside it went on and was smoothed a little otherwise makes no new look.
  static constexpr double kVolumeShare = 0.01;
  struct Signature {
    std::vector<double> marks;
    double volume = 0.0;  ///< cm^3
  };
  struct Extent {
    double volume = 0.0;  ///< cm^3
    double area = 0.0;    ///< cm^2
  };

  std::map<sim::FragmentId, Signature> signaturesOf(const sim::SurfaceTopology& topology,
                                                    const FragmentFollower& followed) const;
  /// Ends the shapes of fragments that look otherwise now, and begins new ones.
  void addShapes(const sim::SurfaceTopology& topology, const FragmentFollower& followed,
                 const std::set<sim::FragmentId>& changed);
  void measure(const sim::SurfaceTopology& topology);

  const sim::Snapshot& first_;
  const std::optional<PartParameters>& parameters_;
  bool givesMaterial_;  ///< of loose nodes, to the fragments beside them
  sim::SurfaceBuilder builder_;
  std::size_t frames_ = 0;
  std::uint64_t version_ = 0;  ///< of what was broken in the last frame
  std::map<sim::FragmentId, Signature> signatures_;
  std::map<sim::FragmentId, ShapedFragment> fragments_;
  std::map<sim::MaterialIndex, Extent> extents_;
};

}  // namespace modeling
