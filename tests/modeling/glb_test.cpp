#include <fstream>
#include <iterator>
#include <set>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "modeling/exchange/export.h"
#include "modeling/exchange/gltf_material.h"
#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "tests/sim/take_sample.h"
#include "tests/support/change_broken.h"
#include "tests/support/flying_pieces.h"
#include "tests/support/point_sets.h"

/// glTF files, read back by assimp.
namespace {

using sim::Vec3;
using Points = std::map<sim::FragmentId, std::vector<Vec3>>;

std::filesystem::path written(const tests::ScratchFolder& scratch, const tests::MemoryTake& take,
                              std::string* remark = nullptr) {
  const auto path = scratch.file("pieces.glb");
  modeling::ExportRequest request{.path = path, .lastFrame = take.frameCount() - 1, .progress = {}};
  if (remark != nullptr) request.remark = [remark](const std::string& text) { *remark = text; };
  REQUIRE(modeling::writeGlb(take, request).ok());
  return path;
}

/// A node's animated transform, by what glTF says of keys.
aiMatrix4x4 localAt(const aiScene& scene, const aiNode& node, double seconds) {
  for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
    const aiAnimation& animation = *scene.mAnimations[a];
    for (unsigned c = 0; c < animation.mNumChannels; ++c) {
      const aiNodeAnim& channel = *animation.mChannels[c];
      if (channel.mNodeName != node.mName) continue;
      const double ticks = seconds * animation.mTicksPerSecond;
      const auto between = [&](const auto* keys, unsigned count, const auto& mix) {
        unsigned next = 0;
        while (next < count && keys[next].mTime < ticks) ++next;
        if (next == 0) return keys[0].mValue;
        if (next == count) return keys[count - 1].mValue;
        const double span = keys[next].mTime - keys[next - 1].mTime;
        return mix(keys[next - 1].mValue, keys[next].mValue,
                   static_cast<float>((ticks - keys[next - 1].mTime) / span));
      };
      const aiVector3D position =
          between(channel.mPositionKeys, channel.mNumPositionKeys,
                  [](const aiVector3D& p, const aiVector3D& q, float t) { return p + (q - p) * t; });
      const aiQuaternion rotation = between(channel.mRotationKeys, channel.mNumRotationKeys,
                                            [](const aiQuaternion& p, const aiQuaternion& q, float t) {
                                              aiQuaternion mixed;
                                              aiQuaternion::Interpolate(mixed, p, q, t);
                                              return mixed;
                                            });
      return {aiVector3D(1, 1, 1), rotation, position};
    }
  }
  return node.mTransformation;
}

aiMatrix4x4 globalAt(const aiScene& scene, const aiNode& node, double seconds) {
  const aiMatrix4x4 local = localAt(scene, node, seconds);
  return node.mParent == nullptr ? local : globalAt(scene, *node.mParent, seconds) * local;
}

/// Metres, y up, to centimetres, z up.
Vec3 ours(const aiVector3D& v) {
  return 100.0 * Vec3(static_cast<double>(v.x), -static_cast<double>(v.z), static_cast<double>(v.y));
}

sim::FragmentId idOf(const std::string& name) {
  REQUIRE(name.starts_with("fragment_"));
  return static_cast<sim::FragmentId>(std::stoul(name.substr(9)));
}

void addNode(const aiScene& scene, const aiNode& node, double seconds, Points& points) {
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    if (mesh.HasBones()) {
      for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        const aiBone& bone = *mesh.mBones[b];
        const aiNode* joint = scene.mRootNode->FindNode(bone.mName);
        REQUIRE(joint != nullptr);
        const aiMatrix4x4 moved = globalAt(scene, *joint, seconds) * bone.mOffsetMatrix;
        for (unsigned w = 0; w < bone.mNumWeights; ++w) {
          if (bone.mWeights[w].mWeight < 0.5F) continue;
          points[idOf(bone.mName.C_Str())].push_back(
              ours(moved * mesh.mVertices[bone.mWeights[w].mVertexId]));
        }
      }
      continue;
    }
    const aiMatrix4x4 moved = globalAt(scene, node, seconds);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v)
      points[idOf(node.mName.C_Str())].push_back(ours(moved * mesh.mVertices[v]));
  }
  for (unsigned child = 0; child < node.mNumChildren; ++child)
    addNode(scene, *node.mChildren[child], seconds, points);
}

void checkFrames(const tests::MemoryTake& take, const aiScene& scene) {
  for (std::size_t frame = 0; frame < take.frameCount(); ++frame) {
    Points read;
    addNode(scene, *scene.mRootNode, take.frameTime(frame), read);
    const auto expected = tests::pointsByFragment(tests::surfaceOfPieces(take, frame));
    REQUIRE(read.size() == expected.size());
    double worst = 0.0;
    for (const auto& [id, points] : expected) worst = std::max(worst, tests::apart(points, read[id]));
    CHECK(worst < 1e-4);
  }
}

TEST_CASE("another program finds every piece of a glb where it flies, frame by frame") {
  const tests::MemoryTake take = tests::flyingPieces(4, 25);
  const tests::ScratchFolder scratch;
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(written(scratch, take).string(), aiProcess_ValidateDataStructure);
  INFO(importer.GetErrorString());
  REQUIRE(scene != nullptr);
  std::set<std::string> materials;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m)
    materials.insert(scene->mMaterials[scene->mMeshes[m]->mMaterialIndex]->GetName().C_Str());
  CHECK(materials == std::set<std::string>{"test_inside", "test_outside"});
  checkFrames(take, *scene);
}

TEST_CASE("with more fragments than programs take as objects, a glb has one skin that moves alike") {
  const tests::MemoryTake take = tests::flyingPieces(modeling::kMostFragmentNodes + 1, 5);
  const tests::ScratchFolder scratch;
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(written(scratch, take).string(), 0);
  INFO(importer.GetErrorString());
  REQUIRE(scene != nullptr);
  CHECK(scene->mNumMeshes == 2);
  checkFrames(take, *scene);
}

nlohmann::json jsonOf(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  REQUIRE(bytes.size() > 20);
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, sizeof(length));
  REQUIRE(20 + length <= bytes.size());
  return nlohmann::json::parse(bytes.substr(20, length));
}

/// A slab that stands still.
tests::MemoryTake slabTake(const Vec3& size) {
  modeling::Scene scene;
  modeling::SceneMaterial clay;
  clay.name = clay.values.name = "clay";
  clay.values.youngsModulus = 1e7;
  clay.values.threshold.mean = 0.05;
  scene.materials.push_back(clay);
  modeling::Part slab;
  slab.name = "slab";
  slab.material = "clay";
  slab.shape = modeling::SlabShape{size, {1.0, {}}};
  scene.parts.push_back(slab);
  const sim::Network network = modeling::build(scene, {}).value().network;
  sim::Snapshot moment = sim::momentAtRest(network);
  tests::changeBroken(moment, [&](sim::Broken& broken) {
    broken.fragments = {{.id = 0, .nodeCount = static_cast<std::uint32_t>(network.nodeCount())}};
  });
  moment.fragments = {{.id = 0}};
  return {network, {moment}, modeling::writeScene(scene)};
}

TEST_CASE("another program finds the parts' own parameters as texture coordinates of a glb") {
  const Vec3 size(6.0, 4.0, 3.0);
  const tests::MemoryTake take = slabTake(size);
  const tests::ScratchFolder scratch;
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(written(scratch, take).string(), 0);
  REQUIRE(scene != nullptr);
  Eigen::AlignedBox3d box;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    for (unsigned v = 0; v < scene->mMeshes[m]->mNumVertices; ++v)
      box.extend(ours(scene->mMeshes[m]->mVertices[v]));
  }
  unsigned triangles = 0;
  double worst = 0.0;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    REQUIRE(mesh.HasTextureCoords(0));
    for (unsigned f = 0; f < mesh.mNumFaces; ++f, ++triangles) {
      const unsigned* const corners = mesh.mFaces[f].mIndices;
      const Vec3 a = ours(mesh.mVertices[corners[0]]);
      const Vec3 normal =
          (ours(mesh.mVertices[corners[1]]) - a).cross(ours(mesh.mVertices[corners[2]]) - a).normalized();
      Eigen::Index across = 0;
      normal.cwiseAbs().maxCoeff(&across);
      for (unsigned c = 0; c < 3; ++c) {
        // A slab's parameters go along its edges; a side has the two that do not lead through it.
        const Vec3 share = (ours(mesh.mVertices[corners[c]]) - box.min()).cwiseQuotient(size);
        const aiVector3D& read = mesh.mTextureCoords[0][corners[c]];
        worst = std::max({worst, std::abs(static_cast<double>(read.x) - share[across == 0 ? 1 : 0]),
                          std::abs(static_cast<double>(read.y) - share[across == 2 ? 1 : 2])});
      }
    }
  }
  CHECK(triangles == 2 * 2 * (6 * 4 + 6 * 3 + 4 * 3));
  // Single precision of a metre.
  CHECK(worst < 1e-5);
}

TEST_CASE("another program finds the glaze of a glb on the outside alone") {
  const tests::MemoryTake take = tests::flyingPieces(4, 3);
  const tests::ScratchFolder scratch;
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(written(scratch, take).string(), 0);
  REQUIRE(scene != nullptr);
  int found = 0;
  for (unsigned m = 0; m < scene->mNumMaterials; ++m) {
    const aiMaterial& material = *scene->mMaterials[m];
    const std::string name = material.GetName().C_Str();
    if (name != "test_outside" && name != "test_inside") continue;
    ++found;
    ai_real coat = 0;
    material.Get(AI_MATKEY_CLEARCOAT_FACTOR, coat);
    // What a scene does not state of a material's look is half glazed.
    CHECK(coat == Approx(name == "test_outside" ? modeling::Look().glaze : 0.0));
  }
  CHECK(found == 2);
}

TEST_CASE("glass goes into a glb clear, broken or not, and what is matt without a coat") {
  modeling::Look look;
  look.finish = modeling::Finish::glass;
  for (const bool inside : {false, true}) {
    const auto material = modeling::gltfMaterial("glass", look, inside);
    CHECK(material["extensions"]["KHR_materials_transmission"]["transmissionFactor"] == 1.0);
    CHECK(modeling::gltfMaterialExtensions(material).size() == 2);
  }
  look.finish = modeling::Finish::matte;
  CHECK(modeling::gltfMaterialExtensions(modeling::gltfMaterial("clay", look, false)).empty());
}

TEST_CASE("a glb says of each fragment who it is, and of the whole how well it fits") {
  const tests::MemoryTake take = tests::flyingPieces(4, 25);
  const tests::ScratchFolder scratch;
  std::string remark;
  const auto json = jsonOf(written(scratch, take, &remark));
  CHECK(remark.starts_with("4 fragments"));
  const auto& nodes = json.at("nodes");
  REQUIRE(nodes.size() == 5);
  CHECK(nodes[0].at("extras").at("frames_per_second") == 24.0);
  CHECK(nodes[0].at("extras").at("fit_residual_max_cm") < 1e-9);
  CHECK(nodes[1].at("extras").at("parent").is_null());
  for (std::size_t piece = 0; piece < 4; ++piece) {
    const auto& node = nodes[piece + 1];
    CHECK(node.at("name") == "fragment_" + std::to_string(piece));
    CHECK(node.at("extras").at("id") == piece);
    CHECK(node.at("extras").at("mass_g") == 8.0 + static_cast<double>(piece));
    CHECK(node.at("extras").at("birth_time_s") == (piece == 0 ? 0.0 : 0.01));
  }
  const auto& attributes = json.at("meshes")[0].at("primitives")[0].at("attributes");
  for (const char* name : {"POSITION", "NORMAL", "COLOR_0"}) CHECK(attributes.contains(name));
  // The first lies still and the other three need both channels.
  CHECK(json.at("animations")[0].at("channels").size() == 6);
}

}  // namespace
