#include "modeling/import/gltf_reader.h"

#include <algorithm>
#include <set>

#include <Eigen/Geometry>

#include "modeling/import/gltf_primitive.h"

namespace modeling {
namespace {

using sim::Problem;
using sim::Status;
using sim::Vec3;
using Transform = Eigen::Affine3d;

std::vector<double> numbersOf(const GltfJson& list) {
  std::vector<double> numbers;
  if (!list.is_array()) return numbers;
  for (const GltfJson& number : list) numbers.push_back(number.is_number() ? number.get<double>() : 0.0);
  return numbers;
}

Transform matrixOf(const double* columns) {
  Transform transform;
  transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(columns);
  return transform;
}

/// x, y, z, w.
Eigen::Quaterniond turnOf(const double* numbers) {
  const Eigen::Quaterniond turn(numbers[3], numbers[0], numbers[1], numbers[2]);
  return turn.norm() > 0.0 ? turn.normalized() : Eigen::Quaterniond::Identity();
}

Transform parentFromNode(const GltfJson& node) {
  if (const auto matrix = numbersOf(member(node, "matrix")); matrix.size() == 16)
    return matrixOf(matrix.data());
  Transform transform = Transform::Identity();
  if (const auto move = numbersOf(member(node, "translation")); move.size() == 3)
    transform.translate(Vec3(move[0], move[1], move[2]));
  if (const auto turn = numbersOf(member(node, "rotation")); turn.size() == 4)
    transform.rotate(turnOf(turn.data()));
  if (const auto scale = numbersOf(member(node, "scale")); scale.size() == 3)
    transform.scale(Vec3(scale[0], scale[1], scale[2]));
  return transform;
}

/// Where each copy of a node's mesh is within the node (EXT_mesh_gpu_instancing).
sim::Result<std::vector<Transform>> copiesOf(GltfDocument& document, const GltfJson& node) {
  const GltfJson& attributes = member(extensionOf(node, "EXT_mesh_gpu_instancing"), "attributes");
  if (!attributes.is_object()) return std::vector<Transform>{Transform::Identity()};
  std::size_t count = 0;
  std::array<GltfNumbers, 3> parts;
  const std::array<const char*, 3> names{"TRANSLATION", "ROTATION", "SCALE"};
  const std::array<std::size_t, 3> widths{3, 4, 3};
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const GltfJson& index = member(attributes, names[p]);
    if (index.is_null()) continue;
    auto numbers = readAccessor(document, index);
    if (!numbers) return numbers.problem();
    if (numbers->width != widths[p] || (count > 0 && numbers->count() != count))
      return Problem{"", "the places of its copies (EXT_mesh_gpu_instancing) are damaged",
                     "copy or export it anew"};
    count = numbers->count();
    parts[p] = std::move(numbers).value();
  }
  std::vector<Transform> copies(count, Transform::Identity());
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = [&](std::size_t p) { return parts[p].values.data() + i * widths[p]; };
    if (!parts[0].values.empty()) copies[i].translate(Vec3(row(0)[0], row(0)[1], row(0)[2]));
    if (!parts[1].values.empty()) copies[i].rotate(turnOf(row(1)));
    if (!parts[2].values.empty()) copies[i].scale(Vec3(row(2)[0], row(2)[1], row(2)[2]));
  }
  return copies;
}

class GltfScene {
 public:
  explicit GltfScene(GltfDocument& document) : document_(document) {}

  Reading run() {
    raw_.stateUnit(100.0, Statement::theFormat);
    raw_.stateUp('y', Statement::theFormat);
    findPlaces();
    for (const auto& [node, worldFromNode] : shown_)
      if (const Status status = addMesh(document_.entry("nodes", node), worldFromNode); !status)
        return status.problem();
    return std::move(raw_);
  }

 private:
  /// The roots of the scene that is shown, or of all where there is none.
  std::vector<std::uint64_t> roots() const {
    const GltfJson& root = document_.root();
    const GltfJson& scenes = member(root, "scenes");
    std::vector<std::uint64_t> found;
    if (scenes.is_array() && !scenes.empty()) {
      const std::uint64_t shown = std::min<std::uint64_t>(countOf(member(root, "scene")), scenes.size() - 1);
      for (const GltfJson& node : member(scenes[shown], "nodes")) found.push_back(countOf(node, kNobody));
      return found;
    }
    std::set<std::uint64_t> children;
    const GltfJson& nodes = member(root, "nodes");
    for (const GltfJson& node : nodes)
      for (const GltfJson& child : member(node, "children")) children.insert(countOf(child, kNobody));
    for (std::uint64_t n = 0; n < nodes.size(); ++n)
      if (children.count(n) == 0) found.push_back(n);
    return found;
  }

  /// Node by node without recursion: a hostile file may nest them as deep as it is long. Each is seen once,
  /// or nodes in a ring would go on for ever.
  void findPlaces() {
    places_.assign(member(document_.root(), "nodes").size(), Transform::Identity());
    std::vector<bool> isSeen(places_.size(), false);
    struct Step {
      std::uint64_t node;
      Transform worldFromParent;
      bool isVisible;
    };
    std::vector<Step> waiting;
    const auto wait = [&](std::uint64_t node, const Transform& world, bool isVisible) {
      if (node < places_.size() && !isSeen[node]) waiting.push_back({node, world, isVisible});
    };
    const std::vector<std::uint64_t> first = roots();
    for (auto root = first.rbegin(); root != first.rend(); ++root) wait(*root, Transform::Identity(), true);
    while (!waiting.empty()) {
      const Step step = waiting.back();
      waiting.pop_back();
      if (isSeen[step.node]) continue;
      isSeen[step.node] = true;
      const GltfJson& node = document_.entry("nodes", step.node);
      const Transform worldFromNode = step.worldFromParent * parentFromNode(node);
      places_[step.node] = worldFromNode;
      const GltfJson& visible = member(extensionOf(node, "KHR_node_visibility"), "visible");
      const bool isVisible = step.isVisible && !(visible.is_boolean() && !visible.get<bool>());
      if (isVisible) shown_.emplace_back(step.node, worldFromNode);
      for (const GltfJson& child : member(node, "children"))
        wait(countOf(child, kNobody), worldFromNode, isVisible);
    }
  }

  Status addMesh(const GltfJson& node, const Transform& worldFromNode) {
    const GltfJson& mesh = document_.entry("meshes", member(node, "mesh"));
    if (member(node, "mesh").is_null() || mesh.is_null()) return sim::Done{};
    std::vector<double> weights = numbersOf(member(node, "weights"));
    if (weights.empty()) weights = numbersOf(member(mesh, "weights"));
    const auto copies = copiesOf(document_, node);
    if (!copies) return copies.problem();
    const auto pose = poseOf(node);
    if (!pose) return pose.problem();
    for (const GltfJson& primitive : member(mesh, "primitives")) {
      const auto made = readPrimitive(document_, primitive, weights);
      if (!made) return made.problem();
      for (const Transform& copy : *copies)
        if (const Status status = addPrimitive(*made, worldFromNode * copy, *pose); !status) return status;
    }
    return sim::Done{};
  }

  /// Of each joint of the node's rig: from the mesh as it was bound to the world. Empty: there is no rig.
  sim::Result<std::vector<Transform>> poseOf(const GltfJson& node) {
    std::vector<Transform> pose;
    if (member(node, "skin").is_null()) return pose;
    const GltfJson& skin = document_.entry("skins", member(node, "skin"));
    for (const GltfJson& joint : member(skin, "joints")) {
      const std::uint64_t at = countOf(joint, places_.size());
      pose.push_back(at < places_.size() ? places_[at] : Transform::Identity());
    }
    const GltfJson& bound = member(skin, "inverseBindMatrices");
    if (bound.is_null()) return pose;
    const auto matrices = readAccessor(document_, bound);
    if (!matrices) return matrices.problem();
    if (matrices->width != 16 || matrices->count() < pose.size())
      return Problem{"", "its rig is damaged: joints without a matrix", "export it without the rig"};
    for (std::size_t j = 0; j < pose.size(); ++j)
      pose[j] = pose[j] * matrixOf(matrices->values.data() + 16 * j);
    return pose;
  }

  /// The mean of the joints that hold the corner; the node's own place where none does.
  static Transform placeOf(const GltfPrimitive& primitive, std::size_t corner, const Transform& worldFromNode,
                           const std::vector<Transform>& pose) {
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    double all = 0.0;
    for (std::size_t set = 0; set < primitive.joints.size(); ++set) {
      for (std::size_t i = 0; i < 4; ++i) {
        const double weight = primitive.weights[set].at(corner, i);
        const auto joint = static_cast<std::size_t>(primitive.joints[set].at(corner, i));
        if (weight <= 0.0 || joint >= pose.size()) continue;
        sum += weight * pose[joint].matrix();
        all += weight;
      }
    }
    if (!(all > 0.0)) return worldFromNode;
    Transform mean;
    mean.matrix() = sum / all;
    return mean;
  }

  Status addPrimitive(const GltfPrimitive& primitive, const Transform& worldFromNode,
                      const std::vector<Transform>& pose) {
    const auto first = static_cast<std::int64_t>(raw_.points.size());
    if (raw_.points.size() + primitive.points.size() > 3 * kMostTriangles)
      return Problem{"", "it has more than " + std::to_string(kMostTriangles) + " triangles",
                     "use a mesh of fewer faces"};
    const bool isRigged = !pose.empty() && !primitive.joints.empty();
    // What a mirror has turned inside out is turned back (glTF 2.0, 3.7.4).
    Transform place = worldFromNode;
    for (std::size_t i = 0; i < primitive.points.size(); ++i) {
      if (isRigged) place = placeOf(primitive, i, worldFromNode, pose);
      raw_.points.push_back(place * primitive.points[i]);
    }
    return addFaces(primitive, first, place.linear().determinant() < 0.0);
  }

  Status addFaces(const GltfPrimitive& primitive, std::int64_t first, bool isMirrored) {
    std::vector<std::int64_t> corners = primitive.corners;
    for (std::int64_t& corner : corners) corner += first;
    if (primitive.mode == 0) raw_.loosePoints += corners.size();
    if (primitive.mode >= 1 && primitive.mode <= 3) raw_.wires += corners.size();
    const std::size_t before = raw_.triangles.size();
    if (primitive.mode == 5) {
      if (const Status status = addStrip(corners, "a strip", raw_); !status) return status;
    }
    const bool isFan = primitive.mode == 6;
    for (std::size_t i = isFan ? 1 : 0;
         primitive.mode != 5 && primitive.mode >= 4 && i + (isFan ? 1 : 2) < corners.size();
         i += isFan ? 1 : 3) {
      const std::vector<std::int64_t> three = isFan ? std::vector{corners[0], corners[i], corners[i + 1]}
                                                    : std::vector{corners[i], corners[i + 1], corners[i + 2]};
      if (const Status status = addPolygon(three, "a triangle", raw_); !status) return status;
    }
    for (std::size_t t = before; isMirrored && t < raw_.triangles.size(); ++t)
      std::swap(raw_.triangles[t][1], raw_.triangles[t][2]);
    return sim::Done{};
  }

  static constexpr std::uint64_t kNobody = ~std::uint64_t{0};

  GltfDocument& document_;
  RawMesh raw_;
  std::vector<Transform> places_;  ///< of all nodes in the world
  std::vector<std::pair<std::uint64_t, Transform>> shown_;
};

}  // namespace

Reading readGltf(std::string_view bytes, const std::filesystem::path& folder) {
  auto document = GltfDocument::read(bytes, folder);
  if (!document) return document.problem();
  return GltfScene(*document).run();
}

}  // namespace modeling
