#include <sstream>
#include <utility>

#include <catch2/catch.hpp>

#include "tests/modeling/written_mesh.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/meshes.h"

/// FBX and Collada, which have nodes, units and axes.
namespace {

using Catch::Contains;
using modeling::MeshUnit;
using modeling::MeshUp;
using sim::Vec3;
using tests::meshOf;
using tests::sizeOf;

const Vec3 kHalf(1.0, 2.0, 4.0);
constexpr double kFloat = 1e-5;

/// An FBX of text: a box, and models that show it.
struct Fbx {
  int up = 1, upSign = 1, front = 2, frontSign = 1, right = 0;
  double unit = 1.0;
  std::vector<std::string> models{"0,0,0/1,1,1"};  ///< where and how large each is
  double shapeKey = -1.0;                          ///< how far it is on, per cent; below 0: there is none

  std::string make() const {
    std::ostringstream text;
    text << "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n\tFBXHeaderVersion: 1003\n\tFBXVersion: "
            "7400\n}\n"
         << "GlobalSettings:  {\n\tVersion: 1000\n\tProperties70:  {\n"
         << number("UpAxis", up) << number("UpAxisSign", upSign) << number("FrontAxis", front)
         << number("FrontAxisSign", frontSign) << number("CoordAxis", right) << number("CoordAxisSign", 1)
         << "\t\tP: \"UnitScaleFactor\", \"double\", \"Number\", \"\"," << unit << "\n\t}\n}\nObjects:  {\n";
    putBox(text);
    for (std::size_t m = 0; m < models.size(); ++m) {
      const std::size_t slash = models[m].find('/');
      text << "\tModel: " << 200 + m << ", \"Model::box" << m
           << "\", \"Mesh\" {\n\t\tVersion: 232\n\t\tProperties70:  {\n"
           << "\t\t\tP: \"Lcl Translation\", \"Lcl Translation\", \"\", \"A\"," << models[m].substr(0, slash)
           << "\n"
           << "\t\t\tP: \"Lcl Scaling\", \"Lcl Scaling\", \"\", \"A\"," << models[m].substr(slash + 1)
           << "\n\t\t}\n\t}\n";
    }
    if (shapeKey >= 0.0)
      text << "\tGeometry: 300, \"Geometry::key\", \"Shape\" {\n\t\tVersion: 100\n\t\tIndexes: *1 "
              "{\n\t\t\ta: 7\n\t\t}\n"
           << "\t\tVertices: *3 {\n\t\t\ta: 0,0,9\n\t\t}\n\t\tNormals: *3 {\n\t\t\ta: 0,0,0\n\t\t}\n\t}\n"
           << "\tDeformer: 301, \"Deformer::keys\", \"BlendShape\" {\n\t\tVersion: 100\n\t}\n"
           << "\tDeformer: 302, \"SubDeformer::key\", \"BlendShapeChannel\" {\n\t\tVersion: "
              "100\n\t\tDeformPercent: "
           << shapeKey << "\n\t\tFullWeights: *1 {\n\t\t\ta: 100\n\t\t}\n\t}\n";
    text << "}\nConnections:  {\n";
    for (std::size_t m = 0; m < models.size(); ++m)
      text << "\tC: \"OO\"," << 200 + m << ",0\n\tC: \"OO\",100," << 200 + m << "\n";
    if (shapeKey >= 0.0) text << "\tC: \"OO\",301,100\n\tC: \"OO\",302,301\n\tC: \"OO\",300,302\n";
    text << "}\n";
    return text.str();
  }

  static std::string number(const std::string& key, int value) {
    return "\t\tP: \"" + key + "\", \"int\", \"Integer\", \"\"," + std::to_string(value) + "\n";
  }

  static void putBox(std::ostringstream& text) {
    const auto box = tests::boxMesh(kHalf);
    text << "\tGeometry: 100, \"Geometry::box\", \"Mesh\" {\n\t\tVertices: *24 {\n\t\t\ta: ";
    const char* comma = "";
    for (const Vec3& point : box.points())
      for (const double number : point) text << std::exchange(comma, ",") << number;
    text << "\n\t\t}\n\t\tPolygonVertexIndex: *36 {\n\t\t\ta: ";
    comma = "";
    for (const auto& t : box.triangles())
      text << std::exchange(comma, ",") << t[0] << ',' << t[1] << ",-" << t[2] + 1;
    text << "\n\t\t}\n\t\tGeometryVersion: 124\n\t}\n";
  }
};

TEST_CASE("an FBX stands as its axes say, whichever is up, and in the unit it states") {
  const auto sizeFor = [](const Fbx& fbx) {
    const auto file = meshOf("a.fbx", fbx.make());
    INFO((file.ok() ? file->remark : file.problem().line()));
    REQUIRE(file.ok());
    CHECK(file->mesh.volume() == Approx(64.0 * fbx.unit * fbx.unit * fbx.unit).epsilon(1e-5));
    return sizeOf(*file);
  };
  CHECK((sizeFor({}) - Vec3(2.0, 8.0, 4.0)).norm() < kFloat);
  CHECK((sizeFor({.up = 2, .front = 1, .frontSign = -1}) - Vec3(2.0, 4.0, 8.0)).norm() < kFloat);
  CHECK((sizeFor({.up = 0, .front = 2, .right = 1}) - Vec3(4.0, 8.0, 2.0)).norm() < kFloat);
  CHECK((sizeFor({.up = 2, .front = 1, .frontSign = -1, .unit = 2.54}) - 2.54 * Vec3(2.0, 4.0, 8.0)).norm() <
        kFloat);
  const auto file = meshOf("a.fbx", Fbx{.up = 0, .front = 2, .right = 1}.make());
  CHECK_THAT(file->remark, Contains("in centimetres and with x up, as the file states"));
}

TEST_CASE("copies of a mesh in an FBX are all there, and mirrored ones keep their outside outside") {
  const auto file = meshOf("a.fbx", Fbx{.models = {"0,0,0/1,1,1", "10,0,0/-1,1,1", "20,0,0/1,2,1"}}.make());
  INFO((file.ok() ? file->remark : file.problem().line()));
  REQUIRE(file.ok());
  CHECK(file->mesh.closed());
  CHECK(file->mesh.triangles().size() == 36);
  CHECK(file->mesh.volume() == Approx(4.0 * 64.0).epsilon(1e-5));
  CHECK_THAT(file->remark, !Contains("inside out"));
}

TEST_CASE("a shape key of an FBX is as far on as the file says") {
  // It draws the last corner out by 9, along what is across.
  for (const double percent : {0.0, 50.0, 100.0}) {
    const auto file = meshOf("a.fbx", Fbx{.shapeKey = percent}.make());
    INFO((file.ok() ? file->remark : file.problem().line()));
    REQUIRE(file.ok());
    CHECK((sizeOf(*file) - Vec3(2.0, 8.0 + 0.09 * percent, 4.0)).norm() < kFloat);
  }
}

/// A Collada of a box; `asset` and `nodes` are what stands in these elements.
std::string collada(const std::string& asset, const std::string& nodes) {
  const auto box = tests::boxMesh(kHalf);
  std::ostringstream text;
  text << R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>)"
       << asset << R"(</asset>
<library_geometries><geometry id="box"><mesh><source id="box-p"><float_array id="box-a" count="24">)";
  for (const Vec3& point : box.points())
    for (const double number : point) text << number << ' ';
  text
      << R"(</float_array><technique_common><accessor source="#box-a" count="8" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="box-v"><input semantic="POSITION" source="#box-p"/></vertices>
<triangles count="12"><input semantic="VERTEX" source="#box-v" offset="0"/><p>)";
  for (const auto& triangle : box.triangles())
    for (const std::uint32_t point : triangle) text << point << ' ';
  text
      << R"(</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s">)"
      << nodes
      << R"(</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
  return text.str();
}

const std::string kShown = R"(<node id="n"><instance_geometry url="#box"/></node>)";

TEST_CASE("what a Collada states of unit and axis counts once, also where the scene repeats it") {
  const std::string text =
      collada(R"(<unit name="centimeter" meter="0.01"/><up_axis>Z_UP</up_axis>)", kShown);
  for (const MeshUnit unit : {MeshUnit::guess, MeshUnit::centimetre}) {
    for (const MeshUp up : {MeshUp::guess, MeshUp::z}) {
      const auto file = meshOf("a.dae", text, unit, up);
      REQUIRE(file.ok());
      CHECK((sizeOf(*file) - Vec3(2.0, 4.0, 8.0)).norm() < kFloat);
      CHECK_THAT(file->remark, Contains("in centimetres and with z up, as the file states"));
    }
  }
  const auto other = meshOf("a.dae", text, MeshUnit::inch, MeshUp::y);
  REQUIRE(other.ok());
  CHECK((sizeOf(*other) - 2.54 * Vec3(2.0, 8.0, 4.0)).norm() < kFloat);
  CHECK_THAT(other->remark, Contains("the file states centimetres"));
}

TEST_CASE("a Collada that states nothing is in metres with y up, and x may be up") {
  const auto plain = meshOf("a.dae", collada("", kShown));
  REQUIRE(plain.ok());
  CHECK((sizeOf(*plain) - 100.0 * Vec3(2.0, 8.0, 4.0)).norm() < 100.0 * kFloat);
  CHECK_THAT(plain->remark, Contains("in metres and with y up, as its format says"));
  const auto across = meshOf("a.dae", collada(R"(<unit meter="0.0254"/><up_axis>X_UP</up_axis>)", kShown));
  REQUIRE(across.ok());
  CHECK((sizeOf(*across) - 2.54 * Vec3(4.0, 8.0, 2.0)).norm() < kFloat);
  CHECK_THAT(across->remark, Contains("in inches and with x up, as the file states"));
}

TEST_CASE("a Collada with shape keys is refused, as its meshes would be lost") {
  std::string text = collada("", kShown);
  text.insert(
      text.find("<library_visual_scenes>"),
      R"(<library_controllers><controller id="k"><morph source="#box"/></controller></library_controllers>)");
  CHECK_THAT(tests::problemOf("a.dae", text), Contains("shape keys (morph)") && Contains("glTF"));
}

TEST_CASE("mirrored nodes and copies of nodes in a Collada are right") {
  const auto file = meshOf("a.dae", collada(R"(<unit meter="0.01"/>)", kShown + R"(
<node id="m"><matrix>-1 0 0 10 0 1 0 0 0 0 1 0 0 0 0 1</matrix><instance_geometry url="#box"/></node>
<node id="c"><translate>20 0 0</translate><scale>1 1 -1</scale><instance_node url="#m"/></node>)"));
  REQUIRE(file.ok());
  CHECK(file->mesh.closed());
  CHECK(file->mesh.triangles().size() == 36);
  CHECK(file->mesh.volume() == Approx(3.0 * 64.0).epsilon(1e-5));
}

}  // namespace
