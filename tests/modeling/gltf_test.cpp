#include <cmath>

#include <catch2/catch.hpp>
#include <meshoptimizer.h>

#include "tests/modeling/written_mesh.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/meshes.h"

/// glTF as other programs write it. Files are in metres, y up; what is read is in cm, z up.
namespace {

using Catch::Contains;
using nlohmann::json;
using sim::Vec3;
using tests::GltfMaker;
using tests::meshOf;
using tests::problemOf;
using tests::sizeOf;

constexpr double kFloat = 1e-4;  ///< cm: of centimetres as floats
const Vec3 kHalf(0.01, 0.02, 0.04);
constexpr double kVolume = 64.0;  ///< cm3, of a box of these half edges

void shows(GltfMaker& maker, const json& nodes) {
  maker.root["scenes"] = {{{"nodes", nodes}}};
}

TEST_CASE("a mirrored node of a glTF keeps its outside outside, and what hangs below a mirror twice, too") {
  GltfMaker maker;
  const std::size_t box = maker.mesh(tests::moved(tests::boxMesh(kHalf), Vec3(0.05, 0.0, 0.0)));
  const std::size_t sound = maker.node({{"mesh", box}});
  const std::size_t mirrored = maker.node({{"mesh", box}, {"scale", {-1, 1, 1}}});
  const std::size_t within = maker.node({{"mesh", box}, {"scale", {-1, 1, 1}}, {"translation", {0, 0.1, 0}}});
  const std::size_t twice =
      maker.node({{"children", {within}}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1}}});
  shows(maker, {sound, mirrored, twice});
  const auto file = meshOf("a.glb", maker.glb());
  REQUIRE(file.ok());
  CHECK(file->mesh.closed());
  CHECK(file->mesh.volume() == Approx(3.0 * kVolume).epsilon(1e-5));
  CHECK_THAT(file->remark, !Contains("inside out"));
  CHECK_THAT(file->remark, Contains("in metres and with y up, as its format says"));
}

TEST_CASE("an open sheet in a mirrored node is turned with it") {
  GltfMaker maker;
  const std::size_t sheet = maker.mesh(tests::sheetMesh(0.05));
  shows(maker, {maker.node({{"mesh", sheet}, {"scale", {-1, 1, 1}}})});
  const auto file = meshOf("a.glb", maker.glb());
  REQUIRE(file.ok());
  const auto& corners = file->mesh.triangles().front();
  const auto& points = file->mesh.points();
  const Vec3 normal =
      (points[corners[1]] - points[corners[0]]).cross(points[corners[2]] - points[corners[0]]);
  // It faces z of the file, which is towards who looks from the front.
  CHECK(normal.y() < 0.0);
}

TEST_CASE("integers that stand for shares, interleaved, are read as what they mean (KHR_mesh_quantization)") {
  for (const bool isShare : {false, true}) {
    GltfMaker maker;
    const auto box = tests::boxMesh(kHalf);
    const std::size_t mesh = maker.mesh(box);
    // Four numbers a corner, the last of which is nothing.
    const double unit = isShare ? 32767.0 : 1000.0;
    std::vector<std::int16_t> numbers;
    for (const Vec3& point : box.points()) {
      for (const double number : point)
        numbers.push_back(static_cast<std::int16_t>(std::lround(number * unit * 20.0)));
      numbers.push_back(77);
    }
    const std::size_t view = maker.view(tests::bytesOf(numbers));
    maker.root["bufferViews"][view]["byteStride"] = 8;
    const std::size_t positions = maker.accessor({{"bufferView", view},
                                                  {"componentType", 5122},
                                                  {"normalized", isShare},
                                                  {"count", box.points().size()},
                                                  {"type", "VEC3"}});
    maker.root["meshes"][mesh]["primitives"][0]["attributes"]["POSITION"] = positions;
    maker.root["extensionsRequired"] = {"KHR_mesh_quantization"};
    const double scale = isShare ? 1.0 / 20.0 : 1.0 / 20.0 / unit;
    shows(maker, {maker.node({{"mesh", mesh}, {"scale", {scale, scale, scale}}})});
    const auto file = meshOf("a.gltf", maker.gltf());
    INFO((file.ok() ? file->remark : file.problem().line()));
    REQUIRE(file.ok());
    CHECK(file->mesh.closed());
    // A number of 16 bits of 5 cm.
    CHECK((sizeOf(*file) - Vec3(2.0, 8.0, 4.0)).norm() < 100.0 * 2.0 / unit / 20.0);
  }
}

TEST_CASE("sparse numbers are laid over others, and over nothing") {
  GltfMaker maker;
  const auto box = tests::boxMesh(kHalf);
  const std::size_t mesh = maker.mesh(box);
  std::vector<float> top;
  std::vector<std::uint8_t> which;
  for (std::size_t i = 0; i < box.points().size(); ++i) {
    if (box.points()[i].y() < 0.0) continue;
    which.push_back(static_cast<std::uint8_t>(i));
    for (const double number : Vec3(box.points()[i] + Vec3(0.0, 0.02, 0.0)))
      top.push_back(static_cast<float>(number));
  }
  const std::size_t indices = maker.view(tests::bytesOf(which));
  const std::size_t values = maker.view(tests::bytesOf(top));
  maker.root["accessors"][0]["sparse"] = {{"count", which.size()},
                                          {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                                          {"values", {{"bufferView", values}}}};
  shows(maker, {maker.node({{"mesh", mesh}})});
  const auto file = meshOf("a.glb", maker.glb());
  REQUIRE(file.ok());
  CHECK((sizeOf(*file) - Vec3(2.0, 8.0, 6.0)).norm() < kFloat);
}

TEST_CASE("shape keys count as much as the node, or else the mesh, says") {
  GltfMaker maker;
  const auto box = tests::boxMesh(kHalf);
  const std::size_t mesh = maker.mesh(box);
  std::vector<float> moves;
  for (const Vec3& point : box.points())
    for (const double number : {0.0, point.y() > 0.0 ? 0.08 : 0.0, 0.0})
      moves.push_back(static_cast<float>(number));
  json& primitive = maker.root["meshes"][mesh]["primitives"][0];
  primitive["targets"] = {{{"POSITION", maker.floats(moves, "VEC3")}}};
  const std::size_t node = maker.node({{"mesh", mesh}});
  shows(maker, {node});
  const auto height = [&] { return sizeOf(*meshOf("a.glb", maker.glb())).z(); };
  CHECK(height() == Approx(4.0));
  maker.root["meshes"][mesh]["weights"] = {0.25};
  CHECK(height() == Approx(6.0));
  maker.root["nodes"][node]["weights"] = {0.5};
  CHECK(height() == Approx(8.0));
}

TEST_CASE("a rig stands as its joints do, whatever the place and size of the node of its mesh") {
  GltfMaker maker;
  const auto box = tests::boxMesh(kHalf);
  const std::size_t mesh = maker.mesh(box);
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
  for (const Vec3& point : box.points()) {
    for (const int joint : {point.y() > 0.0 ? 1 : 0, 0, 0, 0})
      joints.push_back(static_cast<std::uint8_t>(joint));
    for (const float weight : {0.5F, 0.0F, 0.0F, 0.0F})
      weights.push_back(weight);  // half of nothing else is all
  }
  const std::size_t view = maker.view(tests::bytesOf(joints));
  json& attributes = maker.root["meshes"][mesh]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] =
      maker.accessor({{"bufferView", view}, {"componentType", 5121}, {"count", 8}, {"type", "VEC4"}});
  attributes["WEIGHTS_0"] = maker.floats(weights, "VEC4");
  // Joints five times too large, bound by a fifth; the upper one was raised by 3 cm since.
  const std::size_t lower = maker.node({{"scale", {5, 5, 5}}});
  const std::size_t upper = maker.node({{"scale", {5, 5, 5}}, {"translation", {0, 0.03, 0}}});
  std::vector<float> bound;
  for (int joint = 0; joint < 2; ++joint)
    for (int i = 0; i < 16; ++i) bound.push_back(i % 5 != 0 ? 0.0F : i == 15 ? 1.0F : 0.2F);
  maker.root["skins"] = {{{"joints", {lower, upper}}, {"inverseBindMatrices", maker.floats(bound, "MAT4")}}};
  const std::size_t body =
      maker.node({{"mesh", mesh}, {"skin", 0}, {"scale", {0.2, 0.2, 0.2}}, {"translation", {9, 9, 9}}});
  shows(maker, {lower, upper, body});
  const auto file = meshOf("a.glb", maker.glb());
  REQUIRE(file.ok());
  CHECK((sizeOf(*file) - Vec3(2.0, 8.0, 7.0)).norm() < kFloat);
  CHECK(file->mesh.box().min().z() == Approx(-2.0));
}

TEST_CASE("all copies of an instanced mesh are there, mirrored ones too (EXT_mesh_gpu_instancing)") {
  GltfMaker maker;
  const std::size_t mesh = maker.mesh(tests::boxMesh(kHalf));
  const std::size_t places = maker.floats({0, 0, 0, 0.1F, 0, 0, 0.2F, 0, 0}, "VEC3");
  const std::size_t sizes = maker.floats({1, 1, 1, 2, 1, 1, -1, 1, 1}, "VEC3");
  const float half = std::sqrt(0.5F);
  const std::size_t turns = maker.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, half, half}, "VEC4");
  maker.root["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  shows(maker,
        {maker.node(
            {{"mesh", mesh},
             {"extensions",
              {{"EXT_mesh_gpu_instancing",
                {{"attributes", {{"TRANSLATION", places}, {"SCALE", sizes}, {"ROTATION", turns}}}}}}}})});
  const auto file = meshOf("a.glb", maker.glb());
  REQUIRE(file.ok());
  CHECK(file->mesh.triangles().size() == 36);
  CHECK(file->mesh.volume() == Approx(4.0 * kVolume).epsilon(1e-4));
  // From the first's side to the last's, which lies across.
  CHECK(sizeOf(*file).x() == Approx(1.0 + 20.0 + 2.0));
}

TEST_CASE("numbers packed by meshoptimizer are unpacked") {
  GltfMaker maker;
  const auto box = tests::boxMesh(kHalf);
  const std::size_t mesh = maker.mesh(box);
  std::vector<float> corners;
  for (const Vec3& point : box.points())
    for (const double number : point) corners.push_back(static_cast<float>(number));
  std::vector<unsigned> indices;
  for (const auto& triangle : box.triangles())
    indices.insert(indices.end(), triangle.begin(), triangle.end());
  std::string packedCorners(meshopt_encodeVertexBufferBound(8, 12), '\0');
  packedCorners.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(packedCorners.data()),
                                                  packedCorners.size(), corners.data(), 8, 12));
  std::string packedFaces(meshopt_encodeIndexBufferBound(indices.size(), 8), '\0');
  packedFaces.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(packedFaces.data()),
                                               packedFaces.size(), indices.data(), indices.size()));
  const auto pack = [&](const char* accessor, const std::string& bytes, std::size_t count, std::size_t stride,
                        const char* mode) {
    const std::size_t packed = maker.view(bytes);
    json& primitive = maker.root["meshes"][mesh]["primitives"][0];
    const std::size_t at = primitive.contains(accessor)
                               ? primitive[accessor].get<std::size_t>()
                               : primitive["attributes"][accessor].get<std::size_t>();
    const std::size_t view = maker.root["accessors"][at]["bufferView"];
    json extension = maker.root["bufferViews"][packed];
    extension.update({{"count", count}, {"byteStride", stride}, {"mode", mode}});
    // What readers without the extension would read is not there.
    maker.root["bufferViews"][view] = {{"buffer", 1},
                                       {"byteLength", count * stride},
                                       {"extensions", {{"EXT_meshopt_compression", extension}}}};
  };
  pack("POSITION", packedCorners, 8, 12, "ATTRIBUTES");
  pack("indices", packedFaces, indices.size(), 2, "TRIANGLES");
  maker.root["buffers"] = {
      json::object(),
      {{"byteLength", 400}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
  maker.root["extensionsRequired"] = {"EXT_meshopt_compression"};
  shows(maker, {maker.node({{"mesh", mesh}})});
  const auto file = meshOf("a.glb", maker.glb());
  INFO((file.ok() ? file->remark : file.problem().line()));
  REQUIRE(file.ok());
  CHECK(file->mesh.closed());
  CHECK(file->mesh.volume() == Approx(kVolume).epsilon(1e-5));
}

TEST_CASE("strips and fans of triangles, and corners without numbers, are triangles") {
  GltfMaker maker;
  // A pyramid: its sides are a fan, its square base a strip.
  const Vec3 top(0.0, 0.06, 0.0);
  const std::array<Vec3, 4> base{Vec3(-0.03, 0, 0.03), Vec3(0.03, 0, 0.03), Vec3(0.03, 0, -0.03),
                                 Vec3(-0.03, 0, -0.03)};
  std::vector<float> fan, strip;
  const auto put = [](std::vector<float>& numbers, const Vec3& point) {
    for (const double number : point) numbers.push_back(static_cast<float>(number));
  };
  for (const Vec3& point : {top, base[0], base[1], base[2], base[3], base[0]}) put(fan, point);
  for (const Vec3& point : {base[0], base[3], base[1], base[2]}) put(strip, point);
  maker.root["meshes"] = {{{"primitives",
                            {{{"mode", 6}, {"attributes", {{"POSITION", maker.floats(fan, "VEC3")}}}},
                             {{"mode", 5}, {"attributes", {{"POSITION", maker.floats(strip, "VEC3")}}}}}}}};
  shows(maker, {maker.node({{"mesh", 0}})});
  const auto file = meshOf("a.glb", maker.glb());
  REQUIRE(file.ok());
  CHECK(file->mesh.closed());
  CHECK(file->mesh.volume() == Approx(72.0).epsilon(1e-5));
}

TEST_CASE("only the scene that is shown is read, without what it hides") {
  GltfMaker maker;
  const std::size_t box = maker.mesh(tests::boxMesh(kHalf));
  const std::size_t ball = maker.mesh(tests::ballMesh(0.05, 6));
  const std::size_t shown = maker.node({{"mesh", box}});
  const std::size_t hidden = maker.node({{"mesh", ball}});
  const std::size_t parent =
      maker.node({{"children", {hidden}}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}});
  maker.root["scenes"] = {{{"nodes", {hidden}}}, {{"nodes", {shown, parent}}}};
  maker.root["scene"] = 1;
  const auto file = meshOf("a.glb", maker.glb());
  REQUIRE(file.ok());
  CHECK(file->mesh.triangles().size() == 12);
}

TEST_CASE("an extension that shapes need and nobody knows here is refused by its name") {
  GltfMaker maker;
  shows(maker, {maker.node({{"mesh", maker.mesh(tests::boxMesh(kHalf))}})});
  maker.root["extensionsRequired"] = {"KHR_materials_volume", "KHR_texture_basisu"};
  CHECK(meshOf("a.glb", maker.glb()).ok());
  maker.root["extensionsRequired"].push_back("ACME_curled_triangles");
  CHECK_THAT(problemOf("a.glb", maker.glb()),
             Contains("needs ACME_curled_triangles") && Contains("export it without"));
}

TEST_CASE("a damaged glTF, or one without its other file, says so") {
  GltfMaker maker;
  shows(maker, {maker.node({{"mesh", maker.mesh(tests::boxMesh(kHalf))}})});
  const std::string whole = maker.glb();
  CHECK_THAT(problemOf("a.glb", whole.substr(0, whole.size() - 10)), Contains("cut short"));
  json apart = maker.root;
  apart["buffers"] = {{{"byteLength", 9}, {"uri", "a%20cup.bin"}}};
  CHECK_THAT(problemOf("a.gltf", apart.dump()), Contains("a cup.bin") && Contains(".glb"));
  apart = maker.root;
  apart["accessors"][0]["count"] = 1'000'000;
  maker.root = apart;
  CHECK_THAT(problemOf("a.glb", maker.glb()), Contains("damaged"));
  CHECK_THAT(problemOf("a.gltf", R"({"asset": {"version": "1.0"}})"), Contains("export it as glTF 2.0"));
  CHECK_THAT(problemOf("a.gltf", "no json"), Contains("no glTF"));
  // Nodes in a ring: each is seen once.
  maker = {};
  maker.node({{"mesh", maker.mesh(tests::boxMesh(kHalf))}, {"children", {1}}});
  maker.node({{"children", {0}}});
  shows(maker, {0});
  CHECK(meshOf("a.glb", maker.glb()).ok());
}

}  // namespace
