#include "modeling/import/assimp_reader.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <optional>
#include <set>

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/scene.h>

#include "modeling/import/mesh_text.h"
#include "modeling/import/shape_keys.h"

namespace modeling {
namespace {

using sim::Problem;
using sim::Status;
using sim::Vec3;

const char* const kAnew = "export it anew, as glTF, OBJ, PLY or STL";

Vec3 vectorOf(const aiVector3D& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

std::string oneShortLine(std::string text) {
  for (char& letter : text)
    if (letter >= 0 && letter < ' ') letter = ' ';
  static constexpr std::size_t kMost = 160;
  if (text.size() > kMost) text = text.substr(0, kMost) + "...";
  return text;
}

class AssimpScene {
 public:
  AssimpScene(const aiScene& scene, const ShapeKeys& shapeKeys) : scene_(scene), shapeKeys_(shapeKeys) {
    findPlaces();
  }

  /// A rig's first bones stand in a node that is moved, turned or scaled.
  bool hasMovedRig() const {
    std::set<std::string> bones;
    for (unsigned m = 0; m < scene_.mNumMeshes; ++m)
      for (unsigned b = 0; b < scene_.mMeshes[m]->mNumBones; ++b)
        bones.insert(scene_.mMeshes[m]->mBones[b]->mName.C_Str());
    constexpr float kRounding = 1e-5F;
    return std::any_of(nodes_.begin(), nodes_.end(), [&](const auto& placed) {
      const aiNode* parent = placed.first->mParent;
      const bool isFirst = parent != nullptr && bones.count(placed.first->mName.C_Str()) > 0 &&
                           bones.count(parent->mName.C_Str()) == 0;
      return isFirst && !places_.at(parent->mName.C_Str()).Equal(aiMatrix4x4(), kRounding);
    });
  }

  Reading run() {
    for (const auto& [node, worldFromNode] : nodes_) {
      for (unsigned m = 0; m < node->mNumMeshes; ++m)
        if (const Status status = addMesh(*scene_.mMeshes[node->mMeshes[m]], worldFromNode); !status)
          return status.problem();
    }
    return std::move(raw_);
  }

 private:
  /// Node by node without recursion: a hostile file may nest them as deep as it is long. What the root is
  /// moved by is assimp's, which has its own mind about units and axes, and is left out.
  void findPlaces() {
    std::vector<std::pair<const aiNode*, aiMatrix4x4>> waiting{{scene_.mRootNode, aiMatrix4x4()}};
    while (!waiting.empty()) {
      const auto [node, worldFromNode] = waiting.back();
      waiting.pop_back();
      nodes_.emplace_back(node, worldFromNode);
      places_.emplace(node->mName.C_Str(), worldFromNode);
      for (unsigned c = node->mNumChildren; c-- > 0;)
        waiting.emplace_back(node->mChildren[c], worldFromNode * node->mChildren[c]->mTransformation);
    }
  }

  Status addMesh(const aiMesh& mesh, const aiMatrix4x4& worldFromNode) {
    const auto first = static_cast<std::int64_t>(raw_.points.size());
    if (raw_.points.size() + mesh.mNumVertices > 3 * kMostTriangles)
      return Problem{"", "it has more than " + std::to_string(kMostTriangles) + " triangles",
                     "use a mesh of fewer faces"};
    const auto weights = weightsOf(mesh);
    if (!weights)
      return Problem{"", "it has shape keys, and how far each is on can't be told in this format",
                     "apply its shape keys before exporting it, or export it as glTF"};
    const std::vector<aiMatrix4x4> places = placesOf(mesh, worldFromNode);
    double determinant = worldFromNode.Determinant();
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiMatrix4x4& place = places.empty() ? worldFromNode : places[v];
      if (v == 0) determinant = place.Determinant();
      raw_.points.push_back(vectorOf(place * shapedPoint(mesh, *weights, v)));
    }
    const std::size_t before = raw_.triangles.size();
    if (const Status status = addFaces(mesh, first); !status) return status;
    // What a mirror has turned inside out is turned back.
    for (std::size_t t = before; determinant < 0.0 && t < raw_.triangles.size(); ++t)
      std::swap(raw_.triangles[t][1], raw_.triangles[t][2]);
    return sim::Done{};
  }

  /// How far each of its shape keys is on; nothing where that can't be told.
  std::optional<std::vector<double>> weightsOf(const aiMesh& mesh) const {
    std::vector<std::string> names;
    for (unsigned k = 0; k < mesh.mNumAnimMeshes; ++k) names.emplace_back(mesh.mAnimMeshes[k]->mName.C_Str());
    return shapeKeys_.weightsOf(names);
  }

  static aiVector3D shapedPoint(const aiMesh& mesh, const std::vector<double>& weights, unsigned vertex) {
    aiVector3D point = mesh.mVertices[vertex];
    for (unsigned k = 0; k < weights.size(); ++k) {
      const aiAnimMesh& key = *mesh.mAnimMeshes[k];
      if (key.mVertices != nullptr && vertex < key.mNumVertices)
        point += static_cast<float>(weights[k]) * (key.mVertices[vertex] - mesh.mVertices[vertex]);
    }
    return point;
  }

  /// From the mesh as it was bound to the world, for each corner: the mean of the bones that hold it. Empty:
  /// there is no rig.
  std::vector<aiMatrix4x4> placesOf(const aiMesh& mesh, const aiMatrix4x4& worldFromNode) const {
    if (mesh.mNumBones == 0) return {};
    const aiMatrix4x4 nothing = aiMatrix4x4() * 0.0F;
    std::vector<aiMatrix4x4> sums(mesh.mNumVertices, nothing);
    std::vector<float> weights(mesh.mNumVertices, 0.0F);
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
      const aiBone& bone = *mesh.mBones[b];
      const auto found = places_.find(bone.mName.C_Str());
      if (found == places_.end()) continue;
      const aiMatrix4x4 place = found->second * bone.mOffsetMatrix;
      for (unsigned w = 0; w < bone.mNumWeights; ++w) {
        const unsigned vertex = bone.mWeights[w].mVertexId;
        const float weight = bone.mWeights[w].mWeight;
        if (vertex >= mesh.mNumVertices || !(weight > 0.0F)) continue;
        sums[vertex] = sums[vertex] + place * weight;
        weights[vertex] += weight;
      }
    }
    for (unsigned v = 0; v < mesh.mNumVertices; ++v)
      sums[v] = weights[v] > 0.0F ? sums[v] * (1.0F / weights[v]) : worldFromNode;
    return sums;
  }

  Status addFaces(const aiMesh& mesh, std::int64_t first) {
    std::vector<std::int64_t> ring;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices == 1) ++raw_.loosePoints;
      if (face.mNumIndices == 2) ++raw_.wires;
      if (face.mNumIndices < 3) continue;
      ring.clear();
      for (unsigned c = 0; c < face.mNumIndices; ++c) ring.push_back(first + face.mIndices[c]);
      if (const Status status = addPolygon(ring, "face " + std::to_string(f + 1), raw_); !status)
        return status;
    }
    return sim::Done{};
  }

  const aiScene& scene_;
  const ShapeKeys& shapeKeys_;
  RawMesh raw_;
  std::vector<std::pair<const aiNode*, aiMatrix4x4>> nodes_;
  std::map<std::string, aiMatrix4x4> places_;
};

int wholeOf(const aiMetadata& data, const char* key, int otherwise) {
  std::int32_t number = otherwise;
  return data.Get(key, number) ? number : otherwise;
}

Vec3 axisOf(const aiMetadata& data, const std::string& name, int otherwise) {
  const int axis = wholeOf(data, (name + "Axis").c_str(), otherwise);
  const double sign = wholeOf(data, (name + "AxisSign").c_str(), 1) < 0 ? -1.0 : 1.0;
  return sign * Vec3::Unit(std::clamp(axis, 0, 2));
}

/// Every FBX states its unit, in cm, and its axes; the front is the side that is seen.
void addFbxStatements(const aiScene& scene, RawMesh& raw) {
  if (scene.mMetaData == nullptr) return;
  const aiMetadata& data = *scene.mMetaData;
  double unit = 0.0;
  float single = 0.0F;
  if (!data.Get("UnitScaleFactor", unit) && data.Get("UnitScaleFactor", single))
    unit = static_cast<double>(single);
  if (unit > 0.0 && std::isfinite(unit)) raw.stateUnit(unit, Statement::theFile);
  const Vec3 up = axisOf(data, "Up", 1);
  const Vec3 front = axisOf(data, "Front", 2);
  const Vec3 right = axisOf(data, "Coord", 0);
  raw.axesSaid = Statement::theFile;
  const bool areThree = std::abs(right.cross(up).dot(front)) == 1.0;
  raw.axes = {right, areThree ? Vec3(-front) : Vec3(up.cross(right)), up};
}

/// assimp moves the root of Collada by the unit and the axes that the file states, or else has for metres and
/// y.
void addColladaStatements(const aiScene& scene, std::string_view text, RawMesh& raw) {
  const aiMatrix4x4& root = scene.mRootNode->mTransformation;
  const auto row = [](float x, float y, float z) { return vectorOf(aiVector3D(x, y, z)); };
  std::array<Vec3, 3> rows{row(root.a1, root.a2, root.a3), row(root.b1, root.b2, root.b3),
                           row(root.c1, root.c2, root.c3)};
  const double unit = rows[1].norm();
  if (!(unit > 0.0) || !std::isfinite(unit)) return;
  const auto said = [&](const char* element) {
    return text.find(element) == std::string_view::npos ? Statement::theFormat : Statement::theFile;
  };
  // A float has no more digits.
  const double centimetres = 100.0 * unit;
  raw.stateUnit(static_cast<double>(std::stof(std::to_string(centimetres))), said("<unit"));
  for (Vec3& axis : rows) axis = (axis / unit).array().round();
  raw.axes = {rows[0], -rows[2], rows[1]};
  raw.axesSaid = said("<up_axis");
}

}  // namespace

Reading readByAssimp(const std::filesystem::path& file, std::string_view bytes, std::string_view ending) {
  const bool isFbx = ending == ".fbx";
  // assimp (5.2 to 5.4) leaves out meshes of Collada that have shape keys.
  if (!isFbx && bytes.find("<morph") != std::string_view::npos)
    return Problem{"", "it has shape keys (morph), which can't be read in Collada",
                   "apply its shape keys before exporting it, or export it as glTF"};
  const ShapeKeys keys(bytes);
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  const aiScene* scene = importer.ReadFile(file.string(), 0);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    const std::string error = importer.GetErrorString();
    if (error.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
    return Problem{
        "", "this mesh cannot be read: " + (error.empty() ? "it holds nothing" : oneShortLine(error)), kAnew};
  }
  AssimpScene read(*scene, keys);
  if (!isFbx && bytes.find("<authoring_tool>Blender") != std::string_view::npos && read.hasMovedRig())
    return Problem{
        "", "its rig was moved or scaled, which Blender writes in Collada otherwise than the format says",
        "apply the rig's location, rotation and scale in Blender (Ctrl+A), or export it as glTF"};
  Reading raw = read.run();
  if (!raw) return raw;
  if (isFbx) addFbxStatements(*scene, *raw);
  if (!isFbx) addColladaStatements(*scene, bytes, *raw);
  return raw;
}

}  // namespace modeling
