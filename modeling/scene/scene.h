#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "modeling/material/material.h"
#include "modeling/shapes/bezier_patch.h"
#include "modeling/shapes/curved_cylinder.h"
#include "modeling/shapes/mesh_shape.h"
#include "modeling/shapes/revolution.h"
#include "modeling/shapes/slab.h"
#include "sim/control/track.h"
#include "sim/state/settings.h"

/// The document: everything an artist edits, undoes and saves. Plain values; what they mean together is
/// checked by checkScene() and made into a simulation by build().
namespace modeling {

/// As written: degrees about the fixed axes x, then y, then z; or a quaternion w, x, y, z of any length above
/// 0.
struct Rotation {
  std::variant<Vec3, Eigen::Vector4d> value = Vec3(Vec3::Zero());

  Eigen::Quaterniond quaternion() const;
  bool operator==(const Rotation&) const = default;
};

/// One factor for all axes, or one an axis; each above 0, because a mirrored cell is turned inside out.
struct Scale {
  Vec3 factors = Vec3::Ones();

  bool operator==(const Scale&) const = default;
};

/// worldFromPart: scale first, then rotation, then position.
struct Placement {
  Vec3 position = Vec3::Zero();  ///< cm
  Rotation rotation;
  Scale scale;

  Eigen::Affine3d worldFromPart() const;
  bool operator==(const Placement&) const = default;
};

struct Box {
  Vec3 min = Vec3::Zero();  ///< cm
  Vec3 max = Vec3::Zero();  ///< cm, not below min on any axis

  bool operator==(const Box&) const = default;
};

enum class NetworkFormat { lammps };

/// Constants of the bonds of one type of a network file.
struct BondType {
  double stiffness = 0.0;            ///< dyn/cm, > 0
  std::optional<double> restLength;  ///< cm, > 0; absent: the bond's length in the file
  double damping = 0.0;              ///< g/s
  std::optional<double> threshold;   ///< t_ij; absent: unbreakable

  bool operator==(const BondType&) const = default;
};

struct NamedBondType {
  std::string type;  ///< as the file names it: a whole number
  BondType constants;

  bool operator==(const NamedBondType&) const = default;
};

/// Raw nodes and bonds from a file. No cells.
struct NetworkShape {
  std::string file;  ///< relative to the scene's folder
  NetworkFormat format = NetworkFormat::lammps;
  std::vector<NamedBondType> bondTypes;

  bool operator==(const NetworkShape&) const = default;
};

using PartShape =
    std::variant<SlabShape, BezierPatchShape, RevolutionShape, CurvedCylinderShape, NetworkShape, MeshShape>;

struct Part {
  std::string name;
  PartShape shape;
  std::string material;  ///< a material's name; a network may leave it out
  Placement worldFromPart;
  Vec3 velocity = Vec3::Zero();         ///< cm/s
  Vec3 angularVelocity = Vec3::Zero();  ///< rad/s, about its centre of mass
  std::vector<Box> hold;                ///< part coordinates: nodes inside are held where they are

  bool operator==(const Part&) const = default;
};

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

struct FloorShape {
  bool operator==(const FloorShape&) const = default;
};
struct BoxShape {
  Vec3 halfSize = Vec3::Ones();  ///< cm
  bool operator==(const BoxShape&) const = default;
};
struct SphereShape {
  double radius = 1.0;  ///< cm
  bool operator==(const SphereShape&) const = default;
};
struct CylinderShape {
  double radius = 1.0;      ///< cm
  double halfHeight = 1.0;  ///< cm, along its z
  bool operator==(const CylinderShape&) const = default;
};

/// The triangles of an obstacle, shared by all copies of the scene; null: not read yet.
struct ObstacleSurface {
  std::shared_ptr<const sim::TriangleMesh> mesh;

  bool operator==(const ObstacleSurface& other) const {
    return mesh == other.mesh || (mesh && other.mesh && *mesh == *other.mesh);
  }
};

/// A mesh that things collide with. One of `file` and `surface` is given; build() reads the file where there
/// is no surface, and what a take is headed by has the surface, so that it can be resumed anywhere.
struct MeshObstacle {
  std::string file;  ///< see MeshSource
  MeshUnit unit = MeshUnit::guess;
  MeshUp up = MeshUp::guess;
  double thickness = 0.4;   ///< of a sheet, which an open mesh is, cm; a closed one is solid
  ObstacleSurface surface;  ///< in the collider's coordinates, cm

  MeshSource source() const { return {file, unit, up}; }
  /// A surface that was not read yet is that of the same file.
  bool operator==(const MeshObstacle& other) const {
    const bool unread = !file.empty() && (!surface.mesh || !other.surface.mesh);
    return source() == other.source() && thickness == other.thickness && (unread || surface == other.surface);
  }
};
using ColliderForm = std::variant<FloorShape, BoxShape, SphereShape, CylinderShape, MeshObstacle>;

/// See sim::Collider.
struct SceneCollider {
  std::string name;
  ColliderForm form;
  Vec3 position = Vec3::Zero();
  Rotation rotation;
  std::optional<double> stiffness;  ///< dyn/cm a node; absent: the node's own
  double dampingRatio = sim::Collider{}.dampingRatio;
  double friction = sim::Collider{}.friction;
  bool visible = true;
  std::optional<std::array<double, 2>> active;  ///< s, from and until, the end excluded; absent: always

  bool operator==(const SceneCollider&) const = default;
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

struct Camera {
  Vec3 position{60.0, -80.0, 50.0};  ///< cm
  Vec3 target = Vec3::Zero();        ///< cm
  double fieldOfView = 35.0;         ///< degrees, vertical
  double aperture = 0.0;             ///< cm, of the lens; 0: a pinhole
  std::optional<double> focus;       ///< cm from the eye; absent: as far as the target

  bool operator==(const Camera&) const = default;
};

/// What surface pictures draw.
enum class PictureSurface {
  cells,  ///< of the cells, with cracks
  level,  ///< where the potential field of the nodes has one value (paper, "Rendering")
};

enum class GroundKind {
  studio,   ///< a visible floor, grey, that fades into the backdrop
  none,     ///< not drawn
  plain,    ///< of one matt colour
  checker,  ///< squares of two colours
  wood,     ///< planks of about the first colour, grained with the second
  shadow,   ///< nothing but the shadows that fall on it
};

/// What things stand on. Where there is no visible floor, all but `studio` and `none` are a plane under them.
struct Ground {
  GroundKind kind = GroundKind::studio;
  std::optional<Colour> colour;  ///< absent: the kind's own, as of `second`
  std::optional<Colour> second;
  double size = 6.0;  ///< cm, of a square; width of a plank

  bool operator==(const Ground&) const = default;
};

enum class BackdropKind { studio, colour, gradient, environment };

/// What is seen where there is nothing.
struct Backdrop {
  BackdropKind kind = BackdropKind::studio;
  Colour colour{0.75, 0.75, 0.75};  ///< of a gradient: at the horizon
  Colour top{0.25, 0.28, 0.32};     ///< of a gradient: overhead

  bool operator==(const Backdrop&) const = default;
};

/// An image of all that is around, which lights the scene in place of the studio's lamps.
struct EnvironmentLight {
  std::string
      image;  ///< file: OpenEXR, Radiance .hdr or PNG, twice as wide as high; empty: the studio's lamps
  double strength = 1.0;  ///< factor
  double turn = 0.0;      ///< degrees about the vertical; at 0 the middle of the image lies towards +y

  bool operator==(const EnvironmentLight&) const = default;
};

struct PictureStyle {
  PictureSurface surface = PictureSurface::cells;
  Ground ground;
  Backdrop backdrop;
  EnvironmentLight environment;

  bool operator==(const PictureStyle&) const = default;
};

struct View {
  std::optional<Camera> camera;  ///< absent: framed around everything
  PictureStyle picture;
  std::vector<std::string>
      hidden;  ///< parts that are simulated, but not drawn; names of nothing count nothing
  std::vector<std::string> locked;  ///< parts and colliders that a click in the viewport passes over

  bool operator==(const View&) const = default;
};

struct Scene {
  std::string name;
  std::vector<SceneMaterial> materials;  ///< names differ
  std::vector<Part> parts;               ///< names differ
  std::vector<Gluing> glue;              ///< done in this order
  SceneEnvironment environment;          ///< names of colliders differ
  std::vector<SceneTrack> tracks;
  Solver solver;
  Output output;
  View view;

  bool operator==(const Scene&) const = default;
};

/// What makes the scene impossible though each value by itself is possible: names given twice or to nothing,
/// keys of a track out of order... The Problem's place is a path, such as "parts[2].material". Looks at no
/// file.
sim::Status checkScene(const Scene& scene);
/// The same of the style alone.
sim::Status checkPictureStyle(const PictureStyle& style);

}  // namespace modeling
