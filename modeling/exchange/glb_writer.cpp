#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "modeling/exchange/damage.h"
#include "modeling/exchange/export.h"
#include "modeling/exchange/fragment_motion.h"
#include "modeling/exchange/gltf_file.h"
#include "modeling/exchange/gltf_material.h"
#include "modeling/exchange/key_reduction.h"
#include "modeling/exchange/part_parameters.h"
#include "modeling/exchange/take_scene.h"
#include "modeling/text/text_output.h"

namespace modeling {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kMetresPerCentimetre = 0.01;
/// Indices of joints have 16 bits.
constexpr std::size_t kMostJoints = 65535;

/// glTF's y is up, and its front is +z: x, z, -y of ours.
std::array<float, 3> upright(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.z()), static_cast<float>(-v.y())};
}

std::array<float, 3> inMetres(const Vec3& v) {
  return upright(kMetresPerCentimetre * v);
}

std::array<float, 4> upright(const Eigen::Quaterniond& q) {
  return {static_cast<float>(q.x()), static_cast<float>(q.z()), static_cast<float>(-q.y()),
          static_cast<float>(q.w())};
}

template <class Numbers>
void put(std::vector<float>& list, const Numbers& numbers) {
  list.insert(list.end(), numbers.begin(), numbers.end());
}

Json numberOrNull(double number) {
  return std::isfinite(number) ? Json(number) : Json(nullptr);
}

/// A point with one of its normals and of its texture coordinates.
using VertexKey = std::tuple<std::uint32_t, std::uint32_t, float, float>;

/// The vertices of one primitive: one for each different key.
struct Vertices {
  std::map<VertexKey, std::uint32_t> known;
  std::vector<float> positions, normals, coordinates, colours, weights;
  std::vector<std::uint16_t> joints;
  std::vector<std::uint32_t> corners;
};

/// Faces of one material on one side.
using Slot = std::pair<sim::MaterialIndex, bool>;

class GlbWriter {
 public:
  /// `mesh`: of motion.split.
  GlbWriter(const sim::TakeReader& take, const Scene& scene, const FragmentMotion& motion,
            const sim::SurfaceMesh& mesh)
      : take_(take),
        scene_(scene),
        motion_(motion),
        mesh_(mesh),
        damage_(damageOfNodes(take.network(), motion.split)),
        skinned_(motion.fragments.size() > kMostFragmentNodes) {
    // Without the scene, or a file that it names, there are none.
    const auto parameters = PartParameters::create(scene, "", take.network());
    if (parameters) coordinates_ = parameters->textureCoordinates(mesh_);
  }

  GltfFile run() {
    for (std::size_t i = 0; i < motion_.fragments.size(); ++i)
      fragmentAt_[motion_.fragments[i].fragment.id] = i;
    sortFaces();
    Json root = {{"name", oneWord(scene_.name, "take")}, {"extras", wholeExtras()}};
    const std::size_t rootNode = file_.append("nodes", std::move(root));
    Json children = Json::array();
    for (std::size_t i = 0; i < motion_.fragments.size(); ++i) children.push_back(addFragment(i));
    Json scenes = Json::array({rootNode});
    if (skinned_ && !slots_.empty()) scenes.push_back(addSkinnedMesh(children));
    if (!children.empty()) file_.json()["nodes"][rootNode]["children"] = std::move(children);
    file_.append(
        "scenes",
        {{"name", oneWord(scene_.name, "take")}, {"nodes", std::move(scenes)}, {"extras", wholeExtras()}});
    file_.json()["scene"] = 0;
    if (!extensions_.empty()) file_.json()["extensionsUsed"] = extensions_;
    addAnimation();
    return std::move(file_);
  }

 private:
  Json wholeExtras() const {
    FitResidual all;
    for (const FitResidual& residual : motion_.residuals) all.add(residual);
    return {{"frames_per_second", motion_.framesPerSecond},
            {"frames", motion_.times.size()},
            {"key_tolerance_cm", kKeyTolerance},
            {"fit_residual_rms_cm", all.rootMeanSquare()},
            {"fit_residual_max_cm", all.largest}};
  }

  Json fragmentExtras(std::size_t i) const {
    const FinalFragment& fragment = motion_.fragments[i];
    const sim::Network& network = take_.network();
    const sim::FragmentId parent = fragment.fragment.parent;
    const auto part = network.nodeParts[fragment.nodes.front()];
    Json extras = {{"id", fragment.fragment.id},
                   {"parent", parent == sim::kNone ? Json(nullptr) : Json(parent)},
                   {"birth_time_s", fragment.fragment.born},
                   {"mass_g", numberOrNull(fragment.fragment.mass)},
                   {"frames_per_second", motion_.framesPerSecond},
                   {"fit_residual_rms_cm", motion_.residuals[i].rootMeanSquare()},
                   {"fit_residual_max_cm", motion_.residuals[i].largest}};
    if (part < network.partNames.size()) extras["part"] = network.partNames[part];
    return extras;
  }

  /// What is drawn of a fragment in slots, or in a skin all in the slots of one mesh.
  void sortFaces() {
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      const auto& face = mesh_.faces[f];
      const auto found = fragmentAt_.find(face.fragment);
      if (found == fragmentAt_.end()) continue;
      slots_[skinned_ ? 0 : found->second][Slot(face.material, face.inside)].push_back(f);
    }
  }

  std::size_t materialOf(const Slot& slot) {
    const auto found = materials_.find(slot);
    if (found != materials_.end()) return found->second;
    const Look look = looksOf(scene_, take_.network())[slot.first];
    const std::string name = oneWord(take_.network().materials[slot.first].name, "material");
    Json material = gltfMaterial(name + (slot.second ? "_inside" : "_outside"), look, slot.second);
    for (const std::string& extension : gltfMaterialExtensions(material)) extensions_.insert(extension);
    return materials_[slot] = file_.append("materials", std::move(material));
  }

  std::uint32_t vertex(Vertices& vertices, std::size_t face, unsigned corner, std::size_t fragment) const {
    const std::uint32_t point = mesh_.faces[face].points[corner];
    const std::uint32_t normal = mesh_.faces[face].normals[corner];
    const Eigen::Vector2f uv =
        coordinates_.empty() ? Eigen::Vector2f(Eigen::Vector2f::Zero()) : coordinates_[face][corner];
    const auto [at, isNew] = vertices.known.try_emplace(VertexKey{point, normal, uv.x(), uv.y()},
                                                        static_cast<std::uint32_t>(vertices.known.size()));
    if (!isNew) return at->second;
    // glTF counts v from the top of a picture.
    put(vertices.coordinates, std::array<float, 2>{uv.x(), 1.0F - uv.y()});
    const Vec3 origin = skinned_ ? Vec3(Vec3::Zero()) : motion_.fragments[fragment].origin;
    put(vertices.positions, inMetres(mesh_.points[point] - origin));
    put(vertices.normals, upright(mesh_.normals[normal]));
    const double whole = 1.0 - damage_[mesh_.nodeOfPoint[point]];
    put(vertices.colours, std::array<float, 4>{1.0F, 1.0F, 1.0F, static_cast<float>(whole)});
    if (skinned_) {
      const auto joint = static_cast<std::uint16_t>(fragment);
      vertices.joints.insert(vertices.joints.end(), {joint, 0, 0, 0});
      put(vertices.weights, std::array<float, 4>{1.0F, 0.0F, 0.0F, 0.0F});
    }
    return at->second;
  }

  Json primitive(const Slot& slot, const std::vector<std::size_t>& faces) {
    Vertices vertices;
    for (const std::size_t f : faces) {
      const auto& face = mesh_.faces[f];
      const std::size_t fragment = fragmentAt_.at(face.fragment);
      for (unsigned c = 2; c < face.cornerCount; ++c) {
        for (const unsigned corner : {0U, c - 1, c})
          vertices.corners.push_back(vertex(vertices, f, corner, fragment));
      }
    }
    Json attributes = {{"POSITION", file_.addPositions(vertices.positions)},
                       {"NORMAL", file_.addVertices(vertices.normals, 3)},
                       {"COLOR_0", file_.addVertices(vertices.colours, 4)}};
    if (!coordinates_.empty()) attributes["TEXCOORD_0"] = file_.addVertices(vertices.coordinates, 2);
    if (skinned_) {
      attributes["JOINTS_0"] = file_.addJoints(vertices.joints);
      attributes["WEIGHTS_0"] = file_.addVertices(vertices.weights, 4);
    }
    return {{"attributes", std::move(attributes)},
            {"indices", file_.addTriangles(vertices.corners)},
            {"material", materialOf(slot)}};
  }

  std::size_t addMesh(std::size_t of, const std::string& name) {
    Json primitives = Json::array();
    for (const auto& [slot, faces] : slots_[of]) primitives.push_back(primitive(slot, faces));
    return file_.append("meshes", {{"name", name}, {"primitives", std::move(primitives)}});
  }

  std::size_t addFragment(std::size_t i) {
    const FinalFragment& fragment = motion_.fragments[i];
    const std::string name = "fragment_" + std::to_string(fragment.fragment.id);
    Json node = {{"name", name}, {"translation", inMetres(fragment.origin)}, {"extras", fragmentExtras(i)}};
    if (!skinned_ && slots_.contains(i)) node["mesh"] = addMesh(i, name);
    return nodes_.emplace_back(file_.append("nodes", std::move(node)));
  }

  std::size_t addSkinnedMesh(const Json& joints) {
    std::vector<float> inverses;
    for (const FinalFragment& fragment : motion_.fragments) {
      const std::array<float, 3> back = inMetres(-fragment.origin);
      put(inverses, std::array<float, 16>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, back[0], back[1], back[2], 1});
    }
    const std::size_t skin = file_.append(
        "skins",
        {{"name", "fragments"}, {"joints", joints}, {"inverseBindMatrices", file_.addValues(inverses, 16)}});
    const std::size_t mesh = addMesh(0, "fragments");
    return file_.append("nodes", {{"name", "fragments"}, {"mesh", mesh}, {"skin", skin}});
  }

  std::vector<float> timesOf(const std::vector<std::size_t>& keys) const {
    std::vector<float> times;
    times.reserve(keys.size());
    for (const std::size_t key : keys) times.push_back(static_cast<float>(motion_.times[key]));
    return times;
  }

  static void addChannel(Json& animation, GltfFile& file, std::size_t node, const char* path,
                         const std::vector<float>& times, const std::vector<float>& values) {
    const std::size_t sampler = animation["samplers"].size();
    animation["samplers"].push_back({{"input", file.addTimes(times)},
                                     {"interpolation", "LINEAR"},
                                     {"output", file.addValues(values, values.size() / times.size())}});
    animation["channels"].push_back({{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}});
  }

  /// Half of the tolerance is for positions, half for rotations. What stands still has no channel.
  void addAnimation() {
    Json animation = {{"name", "take"}, {"channels", Json::array()}, {"samplers", Json::array()}};
    for (std::size_t i = 0; i < motion_.fragments.size(); ++i) {
      const std::vector<Pose>& poses = motion_.poses[i];
      const auto moved = positionKeys(poses, 0.5 * kKeyTolerance);
      std::vector<float> values;
      for (const std::size_t key : moved) put(values, inMetres(poses[key].position));
      if (moved.size() > 1) addChannel(animation, file_, nodes_[i], "translation", timesOf(moved), values);
      const auto turned = rotationKeys(poses, motion_.fragments[i].radius, 0.5 * kKeyTolerance);
      values.clear();
      for (const std::size_t key : turned) put(values, upright(poses[key].rotation));
      if (turned.size() > 1) addChannel(animation, file_, nodes_[i], "rotation", timesOf(turned), values);
    }
    if (!animation["channels"].empty()) file_.append("animations", std::move(animation));
  }

  const sim::TakeReader& take_;
  const Scene& scene_;
  const FragmentMotion& motion_;
  const sim::SurfaceMesh& mesh_;
  std::vector<double> damage_;
  bool skinned_;
  std::vector<FaceCoordinates> coordinates_;  ///< one a face; empty: there are none
  GltfFile file_;
  std::map<sim::FragmentId, std::size_t> fragmentAt_;
  std::map<std::size_t, std::map<Slot, std::vector<std::size_t>>> slots_;  ///< by fragment: its faces
  std::map<Slot, std::size_t> materials_;
  std::set<std::string> extensions_;  ///< that materials use
  std::vector<std::size_t> nodes_;    ///< of the file, one a fragment
};

/// Leaves out the nodes whose material was given to the fragments beside them.
void keepDrawn(const sim::SurfaceMesh& mesh, FragmentMotion& motion) {
  std::set<sim::FragmentId> drawn;
  for (const auto& face : mesh.faces) drawn.insert(face.fragment);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < motion.fragments.size(); ++i) {
    if (!drawn.contains(motion.fragments[i].fragment.id)) continue;
    if (kept != i) {
      motion.fragments[kept] = std::move(motion.fragments[i]);
      motion.poses[kept] = std::move(motion.poses[i]);
      motion.residuals[kept] = motion.residuals[i];
    }
    ++kept;
  }
  motion.fragments.resize(kept);
  motion.poses.resize(kept);
  motion.residuals.resize(kept);
}

void remarkOnFit(const FragmentMotion& motion, const ExportRequest& request) {
  if (!request.remark) return;
  FitResidual all;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < motion.residuals.size(); ++i) {
    all.add(motion.residuals[i]);
    if (motion.residuals[i].largest > motion.residuals[worst].largest) worst = i;
  }
  if (motion.fragments.empty()) return;
  request.remark(std::to_string(motion.fragments.size()) + " fragments as rigid pieces; their nodes are " +
                 std::to_string(all.rootMeanSquare()) + " cm (RMS) from there, at most " +
                 std::to_string(all.largest) + " cm in fragment " +
                 std::to_string(motion.fragments[worst].fragment.id) + "; pc2 and ply hold what deforms");
}

}  // namespace

sim::Status writeGlb(const sim::TakeReader& take, const ExportRequest& request) {
  assert(request.firstFrame <= request.lastFrame && request.lastFrame < take.frameCount());
  const auto scene = sceneOf(take);
  if (!scene) return scene.problem();
  auto motion = fragmentMotion(take, request, 0.9);
  if (!motion) return motion.problem();
  const sim::SurfaceMesh mesh = sim::SurfaceBuilder(take.network(), request.looseNodes).build(motion->split);
  if (request.looseNodes == sim::LooseNodes::givenToNeighbours) keepDrawn(mesh, *motion);
  if (motion->fragments.size() > kMostJoints) {
    return sim::Problem{
        request.path.string(),
        "there are more fragments than the " + std::to_string(kMostJoints) + " of a glTF skin",
        "export fewer frames, or another format"};
  }
  const GltfFile file = GlbWriter(take, *scene, *motion, mesh).run();
  if (auto status = file.write(request.path); !status) return status;
  remarkOnFit(*motion, request);
  if (request.progress) request.progress(1.0);
  return sim::Done{};
}

}  // namespace modeling
