#include <cmath>
#include <numbers>
#include <set>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "modeling/exchange/export.h"
#include "modeling/exchange/gltf_material.h"
#include "modeling/exchange/rounded_surface.h"
#include "modeling/material/glass.h"
#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "tests/sim/take_sample.h"
#include "tests/support/change_broken.h"
#include "tests/support/flying_pieces.h"
#include "tests/support/point_sets.h"
#include "tests/support/read_glb.h"

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
    // assimp takes channels that it does not know for motion.
    if (animation.mName != aiString("take")) continue;
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
      // Whether it is there: the newest key counts.
      aiVector3D scale = channel.mScalingKeys[0].mValue;
      for (unsigned k = 1; k < channel.mNumScalingKeys; ++k) {
        if (channel.mScalingKeys[k].mTime <= ticks + 1e-3) scale = channel.mScalingKeys[k].mValue;
      }
      return {scale, rotation, position};
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
  const aiMatrix4x4 moved = globalAt(scene, node, seconds);
  if (moved.Determinant() == 0) return;
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    CHECK(!mesh.HasBones());
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      for (unsigned c = 0; c < 3; ++c)
        points[idOf(node.mName.C_Str())].push_back(ours(moved * mesh.mVertices[mesh.mFaces[f].mIndices[c]]));
    }
  }
  for (unsigned child = 0; child < node.mNumChildren; ++child)
    addNode(scene, *node.mChildren[child], seconds, points);
}

void checkFrames(const tests::MemoryTake& take, const aiScene& scene) {
  for (std::size_t frame = 0; frame < take.frameCount(); ++frame) {
    Points read;
    addNode(scene, *scene.mRootNode, take.frameTime(frame), read);
    const auto expected =
        tests::pointsByFragment(sim::SurfaceBuilder(take.network()).build(**take.frame(frame)));
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

TEST_CASE("hundreds of fragments are nodes of a glb each, which no bounds of a first pose hide") {
  const tests::MemoryTake take = tests::flyingPieces(501, 5);
  const tests::ScratchFolder scratch;
  const auto path = written(scratch, take);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path.string(), 0);
  INFO(importer.GetErrorString());
  REQUIRE(scene != nullptr);
  checkFrames(take, *scene);
  const tests::ReadGlb read(path);
  CHECK(!read.json().contains("skins"));
  // One for what was whole, and one for each piece.
  CHECK(read.json().at("meshes").size() == 502);
  // What each adds to the file: twelve vertices of cube and crack a face, two materials, six channels.
  CHECK(std::filesystem::file_size(path) < 501 * 7000);
}

TEST_CASE("in a glb a body is one closed mesh until it breaks, and in each frame the right ones are seen") {
  const tests::MemoryTake take = tests::crumblingBar(6);
  const tests::ScratchFolder scratch;
  const tests::ReadGlb read(written(scratch, take));
  CHECK(read.shownAt(0.0, false) == std::vector<std::string>{"fragment_0_from_0"});
  for (std::size_t frame = 0; frame < take.frameCount(); ++frame) {
    CAPTURE(frame);
    // Keys have single precision, and count from where they are on.
    const double seconds = static_cast<double>(static_cast<float>(take.frameTime(frame)));
    // Fragment 0 looks otherwise in each frame, and those that came off as they did.
    std::set<std::string> expected{"fragment_0_from_" + std::to_string(frame)};
    for (std::size_t id = 1; id <= frame; ++id) expected.insert("fragment_" + std::to_string(id));
    double volume = 0.0;
    for (const bool extension : {false, true}) {
      const auto shown = read.shownAt(seconds, extension);
      CHECK(std::set<std::string>(shown.begin(), shown.end()) == expected);
      CHECK(shown.size() == expected.size());
    }
    for (const std::string& name : expected) {
      const auto triangles = read.triangles(name, seconds);
      CHECK(tests::isClosed(triangles));
      volume += tests::volumeOf(triangles);
    }
    // A bar of 11 cells of 1 cm^3; single precision.
    CHECK(volume == Approx(11.0).epsilon(1e-5));
    // Between frames nothing is gone and nothing there twice.
    if (frame + 1 < take.frameCount())
      CHECK(read.shownAt(seconds + 0.02, false) == read.shownAt(seconds, false));
  }
}

TEST_CASE("nothing of what will break is in the mesh of what is whole") {
  const tests::ScratchFolder scratch;
  const tests::ReadGlb broken(written(scratch, tests::crumblingBar(6)));
  const auto whole = broken.triangles("fragment_0_from_0", 0.0);
  CHECK(whole.size() == 2 * (4 * 11 + 2));
  for (const auto& triangle : whole) {
    const Vec3 across = (triangle[1].position - triangle[0].position)
                            .cross(triangle[2].position - triangle[0].position)
                            .normalized();
    for (const auto& corner : triangle) {
      CHECK(corner.damage == 0.0);
      // A bar has flat sides: every normal is its side's.
      CHECK((corner.normal - across).norm() < 1e-6);
    }
  }
  double most = 0.0;
  for (const auto& triangle : broken.triangles("fragment_5", 5.0)) {
    for (const auto& corner : triangle) most = std::max(most, corner.damage);
  }
  CHECK(most > 0.0);
  CHECK(most <= 1.0);
  for (const auto& mesh : broken.json().at("meshes")) {
    for (const auto& primitive : mesh.at("primitives"))
      CHECK(!primitive.at("attributes").contains("COLOR_0"));
  }
}

TEST_CASE("what a glb needs a program to know is nothing but glTF 2.0") {
  const tests::ScratchFolder scratch;
  const tests::ReadGlb read(written(scratch, tests::crumblingBar(3)));
  CHECK(!read.json().contains("extensionsRequired"));
  const std::set<std::string> used = read.json().at("extensionsUsed");
  for (const char* name : {"KHR_node_visibility", "KHR_animation_pointer"}) CHECK(used.contains(name));
  // Who plays nothing sees what is there at first, and who knows visibility but not how it is animated goes
  // by the scale.
  for (const char* name : {"fragment_1", "fragment_0_from_1"}) {
    CHECK(read.node(name).at("scale") == nlohmann::json{0.0, 0.0, 0.0});
    CHECK(read.node(name).at("extensions").at("KHR_node_visibility").at("visible") == true);
  }
  CHECK(!read.node("fragment_0_from_0").contains("scale"));
  for (const auto& channel : read.json().at("animations")[0].at("channels"))
    CHECK(channel.at("target").at("path") != "pointer");
}

/// A frame of one part of clay.
tests::MemoryTake standing(modeling::PartShape shape) {
  modeling::Scene scene;
  modeling::SceneMaterial clay;
  clay.name = clay.values.name = "clay";
  clay.values.youngsModulus = 1e7;
  clay.values.threshold.mean = 0.05;
  scene.materials.push_back(clay);
  modeling::Part part;
  part.name = "part";
  part.material = "clay";
  part.shape = std::move(shape);
  scene.parts.push_back(part);
  const sim::Network network = modeling::build(scene, {}).value().network;
  sim::Snapshot moment = sim::momentAtRest(network);
  tests::changeBroken(moment, [&](sim::Broken& broken) {
    broken.fragments = {{.id = 0, .nodeCount = static_cast<std::uint32_t>(network.nodeCount())}};
  });
  moment.fragments = {{.id = 0}};
  return {network, {moment}, modeling::writeScene(scene)};
}

TEST_CASE("what pictures draw round is round in a glb: a handle of eight cells around") {
  const double radius = 0.5;
  modeling::CurvedCylinderShape handle;
  handle.curve = {{Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, 2), Vec3(0, 0, 3)}};
  handle.halfWidth = handle.halfDepth = modeling::constantValue(radius);
  handle.resolution.cellSize = 0.4;
  const tests::ScratchFolder scratch;
  const tests::ReadGlb read(written(scratch, standing(handle)));
  const auto triangles = read.triangles("fragment_0", 0.0);
  CHECK(tests::isClosed(triangles));
  double widest = 0.0, off = 0.0, tilted = 0.0, straightest = 1.0;
  std::size_t onSide = 0;
  for (const auto& triangle : triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto& corner = triangle[c];
      if (std::abs(corner.normal.z()) > 0.5) continue;
      ++onSide;
      const Vec3 out = Vec3(corner.position.x(), corner.position.y(), 0.0);
      off = std::max(off, std::abs(out.norm() - radius));
      tilted = std::max(tilted, (corner.normal - out.normalized()).norm());
      const Vec3& next = triangle[(c + 1) % 3].position;
      straightest = std::min(straightest, out.normalized().dot(Vec3(next.x(), next.y(), 0.0).normalized()));
    }
  }
  widest = std::acos(straightest) * 180.0 / std::numbers::pi;
  CHECK(onSide > 30 * 2 * 3);
  // A cubic curve of an eighth of a turn is nearer to the circle than a ten thousandth of its radius.
  CHECK(off < 1e-3 * radius);
  CHECK(tilted < 0.02);
  // Edges of the lattice are not quite even around.
  CHECK(widest < 1.25 * modeling::kRoundAngle);
}

TEST_CASE("another program finds the parts' own parameters as texture coordinates of a glb") {
  const Vec3 size(6.0, 4.0, 3.0);
  const tests::MemoryTake take = standing(modeling::SlabShape{size, {1.0, {}}});
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
  look.outside = {0.8, 0.9, 0.87};
  for (const bool inside : {false, true}) {
    const auto material = modeling::gltfMaterial("glass", look, inside, 0.6);
    CHECK(material["extensions"]["KHR_materials_transmission"]["transmissionFactor"] == 1.0);
    CHECK(modeling::gltfMaterialExtensions(material).size() == 3);
    // What passes a pane is what pictures have behind it: the look's colour to the power of its depth.
    const auto& volume = material["extensions"]["KHR_materials_volume"];
    const double depth =
        volume["thicknessFactor"].get<double>() / volume["attenuationDistance"].get<double>();
    const double base = material["pbrMetallicRoughness"]["baseColorFactor"][0];
    CHECK(base * std::pow(volume["attenuationColor"][0].get<double>(), depth) ==
          Approx(std::pow(0.6038, 0.6 / modeling::kGlassDepth)).epsilon(1e-3));
  }
  look.finish = modeling::Finish::matte;
  CHECK(modeling::gltfMaterialExtensions(modeling::gltfMaterial("clay", look, false, 0.6)).empty());
}

TEST_CASE("a glb says of each fragment who it is, and of the whole how well it fits") {
  const tests::MemoryTake take = tests::flyingPieces(4, 25);
  const tests::ScratchFolder scratch;
  std::string remark;
  const tests::ReadGlb read(written(scratch, take, &remark));
  const auto& json = read.json();
  CHECK(remark.starts_with("4 fragments"));
  const auto& nodes = json.at("nodes");
  // A root, the fragments, and the two that the first looked like.
  REQUIRE(nodes.size() == 7);
  CHECK(nodes[0].at("extras").at("frames_per_second") == 24.0);
  CHECK(nodes[0].at("extras").at("fit_residual_max_cm") < 1e-9);
  for (std::size_t piece = 0; piece < 4; ++piece) {
    const auto& node = read.node("fragment_" + std::to_string(piece));
    CHECK(node.at("extras").at("parent").is_null() == (piece == 0));
    CHECK(node.at("extras").at("id") == piece);
    CHECK(node.at("extras").at("mass_g") == 8.0 + static_cast<double>(piece));
    CHECK(node.at("extras").at("birth_time_s") == (piece == 0 ? 0.0 : 0.01));
  }
  const auto& attributes = json.at("meshes")[0].at("primitives")[0].at("attributes");
  for (const char* name : {"POSITION", "NORMAL", "_DAMAGE"}) CHECK(attributes.contains(name));
  // The first lies still and the other three need both channels; five meshes come or go.
  CHECK(json.at("animations")[0].at("channels").size() == 6 + 5);
  CHECK(json.at("animations")[1].at("channels").size() == 5);
}

}  // namespace
