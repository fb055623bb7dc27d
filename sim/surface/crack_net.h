#pragma once

#include <array>
#include <unordered_map>
#include <vector>

#include <Eigen/Core>

#include "sim/surface/cell_cuts.h"
#include "sim/surface/curved_faces.h"

namespace sim {

/// The outside of all bodies when they were whole: face k is CellComplex::outsideFaces()[k].
struct WholeOutside {
  explicit WholeOutside(const CellComplex& complex);
  WholeOutside(const WholeOutside&) = delete;
  WholeOutside& operator=(const WholeOutside&) = delete;

  SurfaceMesh mesh;
  CurvedFaces curved;
};

/// The surfaces in which the pieces of one body meet, at rest: spanned between the middles of edges, of sides
/// and of cells, and smoothed, so that a crack does not show the staircase of the cells (the paper's own
/// complaint, section "Breakage appearance"). Both sides of a crack have the very same points, so that pieces
/// fit each other exactly, whatever smoothing does.
///
/// A collapsed side of a wedge meets in the middle of the edge that is left of it.
///
/// On the outside, points move along the outside only (as CurvedFaces curves it), and along an edge of the
/// body only on that. No point moves farther than kReach of a cell, so that it stays on its side of the nodes
/// around it.
class CrackNet {
 public:
  /// Share of a cell's edge by which smoothing may move a point; half would reach a node.
  static constexpr double kReach = 0.42;
  /// Next to loose nodes: a shard keeps more than half of its width.
  static constexpr double kShardReach = 0.22;

  /// A middle that pieces may meet in. Nodes of one piece have one group.
  struct Vertex {
    Vec3 start = Vec3::Zero();                            ///< cm
    Vec3 position = Vec3::Zero();                         ///< after smoothing
    Eigen::Matrix3d spans = Eigen::Matrix3d::Identity();  ///< columns: the cell's edges there, cm
    double reach = kReach;
    std::array<NodeIndex, kCellCorners> nodes{};
    std::array<std::uint8_t, kCellCorners> groups{};
    std::uint8_t nodeCount = 0;
    bool outside = false;
    bool fixed = false;                       ///< on an edge of the body that has no direction to move in
    std::uint8_t creaseSide = 0xff;           ///< of outsideFaces[0], where it is on an edge of the body
    Vec3 direction = Vec3::Zero();            ///< outside: the normal; on an edge of the body: along it
    std::vector<std::uint32_t> outsideFaces;  ///< places of the faces it is on
  };
  /// Where two eighths of a cell meet that are of different pieces.
  struct Interface {
    CellIndex cell;
    std::uint8_t edge;                      ///< of kCellEdges
    std::array<std::uint32_t, 4> vertices;  ///< middle of edge, first side, cell, second side
  };
  /// An outside face of which more than the corners are used.
  struct DividedFace {
    /// Vertex on the side after a corner of CellComplex::nodesOf(); a triangle has none after its third.
    std::array<std::uint32_t, 4> middles{kNone, kNone, kNone, kNone};
    std::uint32_t centre = kNone;
    bool cut = false;  ///< its corners are of several pieces
  };

  CrackNet(const CellComplex& complex, const WholeOutside& whole, const CellCuts& cuts,
           const CellComplex::Body& body);

  const std::vector<Vertex>& vertices() const { return vertices_; }
  const std::vector<Interface>& interfaces() const { return interfaces_; }
  const DividedFace* dividedFace(std::uint32_t place) const {
    const auto found = dividedFaces_.find(place);
    return found == dividedFaces_.end() ? nullptr : &found->second;
  }

 private:
  void addInterfaces(CellIndex cell);
  void addCutSides(CellIndex cell);
  void addFans();
  std::uint32_t edgeVertex(CellIndex cell, const CellEdge& edge);
  std::uint32_t edgeVertex(NodeIndex a, NodeIndex b, const Eigen::Matrix3d& spans);
  std::uint32_t sideVertex(std::uint32_t face);
  std::uint32_t collapsedVertex(std::uint32_t face, const SideNodes& side);
  std::uint32_t cellVertex(CellIndex cell);
  std::uint32_t addVertex(Vertex vertex);
  void placeOnEdge(Vertex& vertex, std::span<const CellComplex::OutsideEdge> edges) const;
  void joinGroups(Vertex& vertex, CellIndex cell) const;

  const CellComplex& complex_;
  const WholeOutside& whole_;
  const CellCuts& cuts_;
  std::vector<Vertex> vertices_;
  std::vector<Interface> interfaces_;
  std::unordered_map<std::uint32_t, DividedFace> dividedFaces_;
  std::unordered_map<std::uint64_t, std::uint32_t> vertexOfEdge_;
  std::unordered_map<std::uint32_t, std::uint32_t>
      vertexOfSide_;  ///< by the lowest of the faces that coincide
  std::unordered_map<CellIndex, std::uint32_t> vertexOfCell_;
  std::vector<std::uint32_t> cutPlaces_;  ///< outside faces that are cut, in order
};

/// How the edges of a cell run at local coordinates in [0, 1]^3: columns, cm.
Eigen::Matrix3d cellSpans(const std::array<Vec3, 8>& corners, const Vec3& at);

}  // namespace sim
