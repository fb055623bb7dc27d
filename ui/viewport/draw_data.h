#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Geometry>

#include "sim/collider/collider.h"
#include "sim/network/network.h"
#include "sim/state/snapshot.h"
#include "sim/surface/surface_topology.h"
#include "ui/session/shown.h"
#include "ui/viewport/view_settings.h"

/// What the viewport draws, as arrays that go to the graphics card as they are. Made by the preparing thread,
/// immutable afterwards. Each piece changes at its own pace: what keeps its pointer is not uploaded again.
namespace ui {

/// Of one network, whatever happens to it.
struct LatticeDraw {
  struct Bond {
    sim::NodeIndex a;
    sim::NodeIndex b;
    float restLength;
    float threshold;  ///< infinite: unbreakable
  };
  std::vector<Bond> bonds;
};

/// A face of the surface.
struct DrawnFace {
  std::array<sim::NodeIndex, 4> nodes{};  ///< at or near its corners, counter-clockwise from outside
  sim::CellIndex cell = sim::kNone;
  sim::FragmentId fragment = sim::kNone;
  sim::PartIndex part = 0;
  sim::MaterialIndex material = 0;
  bool inside = false;
};

/// A corner of the tetrahedron or sphere a loose node is drawn as.
struct ShardCorner {
  sim::NodeIndex node;
  std::array<float, 3> offset;  ///< cm, from the node
  std::uint32_t normal;         ///< packNormal()
};

/// How things hang together: another one whenever something breaks.
struct TopologyDraw {
  struct Range {
    sim::PartIndex part = 0;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  sim::SurfaceTopology surface;
  std::vector<std::uint32_t> hungPoints;       ///< of `surface`: those that are at no node
  std::vector<DrawnFace> faces;                ///< sorted by part
  std::vector<Range> partFaces;                ///< of `faces`
  std::vector<std::uint32_t> cornerNodes;      ///< four a face: a node, or behind the nodes a hung point
  std::vector<std::uint32_t> cornersOfNormal;  ///< corners that share a normal stand together
  std::vector<std::uint32_t> firstOfNormal;    ///< where they begin; one more entry than normals
  std::vector<std::uint32_t> indices;          ///< six a face
  std::vector<ShardCorner> shards;             ///< three a side of a loose node's body, by part
  std::vector<Range> partShards;               ///< of corners
  std::vector<std::uint8_t> bondFlags;         ///< sums of BondFlag, one a bond
};

enum BondFlag : std::uint8_t {
  kBondIntact = 0,
  kBondBroken = 1,
  kBondHidden = 2,
  kBondGlue = 4,  ///< joins two parts; besides the others
};

/// Packed colours; alpha is the glaze.
struct ColourDraw {
  std::vector<std::uint32_t> corners;  ///< four a face
  std::vector<std::uint32_t> shards;   ///< one a corner
};

/// Nodes that are drawn as balls.
struct NodeDraw {
  struct Ball {
    sim::NodeIndex node;
    float radius;  ///< cm
    std::uint32_t colour;
  };
  std::vector<Ball> balls;
};

/// Where everything is: another one every frame.
struct MotionDraw {
  std::vector<std::array<float, 4>> positions;  ///< cm, of nodes, then hung points; the fourth is not used
  std::vector<std::uint32_t> normals;           ///< packNormal(), one a corner
};

/// Where the potential field of the nodes has one value.
struct LevelDraw {
  struct Vertex {
    std::array<float, 3> position;
    std::uint32_t normal;
    std::uint32_t colour;
  };
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
};

struct DrawData {
  Shown shown;
  ViewSettings settings;
  std::shared_ptr<const LatticeDraw> lattice;  ///< null where nothing is shown, as are all pieces
  std::shared_ptr<const TopologyDraw> topology;
  std::shared_ptr<const ColourDraw> colours;
  std::shared_ptr<const NodeDraw> nodes;
  std::shared_ptr<const MotionDraw> motion;
  std::shared_ptr<const LevelDraw> level;
  std::vector<sim::Collider> colliders;  ///< of shown.scene, where they are at this time
  Eigen::AlignedBox3d box;               ///< of the nodes, cm
  double milliseconds = 0.0;             ///< it took to prepare
};

/// As GL_INT_2_10_10_10_REV reads it.
std::uint32_t packNormal(const sim::Vec3& unit);
sim::Vec3 unpackNormal(std::uint32_t packed);

}  // namespace ui
