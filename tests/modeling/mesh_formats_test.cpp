#include <catch2/catch.hpp>

#include "tests/modeling/written_mesh.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/meshes.h"

/// OBJ, STL and PLY as programs write them: right, or the reason.
namespace {

using Catch::Contains;
using modeling::MeshUnit;
using modeling::MeshUp;
using sim::Vec3;
using tests::meshOf;
using tests::problemOf;
using tests::sizeOf;

const Vec3 kHalf(2.0, 3.0, 5.0);
/// Floats of these sizes are off by less.
constexpr double kFloat = 1e-5;

void checkBox(const sim::Result<modeling::MeshFile>& file, double factor = 1.0) {
  INFO((file.ok() ? file->remark : file.problem().line()));
  REQUIRE(file.ok());
  CHECK(file->mesh.closed());
  CHECK((sizeOf(*file) - 2.0 * factor * kHalf).norm() < kFloat * factor);
  CHECK(file->mesh.volume() == Approx(240.0 * factor * factor * factor).epsilon(1e-6));
}

TEST_CASE("an OBJ is its corners and faces, whatever is missing of textures, normals and materials") {
  const auto box = tests::boxMesh(kHalf);
  const std::string corners = tests::objText(box);
  std::string text = "mtllib gone.mtl\n" + corners.substr(0, corners.find("f "));
  for (const auto& triangle : box.triangles()) {
    text += 'f';
    for (const std::uint32_t point : triangle)
      text.append(" ").append(std::to_string(point + 1)).append("/9/7");
    text += "\n";
  }
  checkBox(meshOf("a.obj", text));
}

TEST_CASE("an OBJ may count its corners backwards, end its lines as it likes and go on in the next") {
  checkBox(
      meshOf("a.obj",
             "\xef\xbb\xbfv -2 -3 0\r\nv 2 -3 0\r\nv 2 3 \\\r\n0\r\nv -2 3 0\r\nf -1 -2 -3 -4 # below\r\n"
             "v -2 -3 1e1\rv 2 -3 10.0\rv +2 3 10 1\rv -2 3 10 0.5 0.5 0.5\rf 5 6 7 8\r"
             "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8"));
}

TEST_CASE("a face that is bent inwards is filled within its rim") {
  // An L, ten high: 3 of 4 square centimetres.
  const auto file = meshOf("l.obj",
                           "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n"
                           "v 0 0 10\nv 2 0 10\nv 2 1 10\nv 1 1 10\nv 1 2 10\nv 0 2 10\n"
                           "f 6 5 4 3 2 1\nf 9 10 11 12 7 8\n"
                           "f 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n");
  REQUIRE(file.ok());
  CHECK(file->mesh.closed());
  CHECK(file->mesh.volume() == Approx(30.0));
  double area = 0.0;
  for (const auto& t : file->mesh.triangles()) {
    const auto& p = file->mesh.points();
    area += 0.5 * (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm();
  }
  CHECK(area == Approx(2.0 * 3.0 + 8.0 * 10.0));
}

TEST_CASE("what is wrong with an OBJ is said with its line") {
  CHECK_THAT(problemOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"),
             Contains("line 4") && Contains("9 of 3"));
  CHECK_THAT(problemOf("a.obj", "v 0 0 0\nv 1,5 0 0\n"), Contains("line 2") && Contains("commas"));
  CHECK_THAT(problemOf("a.obj", "v 0 0\n"), Contains("line 1") && Contains("fewer than three"));
  CHECK_THAT(problemOf("a.obj", "these are words\n"), Contains("no OBJ"));
  CHECK_THAT(problemOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nsurf 0 1 0 1 1 2 3\n"),
             Contains("curved surfaces"));
}

TEST_CASE("points and wires are called so") {
  CHECK_THAT(problemOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n"),
             Contains("no faces") && Contains("only lines"));
  CHECK_THAT(problemOf("a.obj", "v 0 0 0\nv 1 0 0\n"),
             Contains("no faces") && Contains("make a mesh of them first"));
  CHECK_THAT(problemOf("a.ply",
                       "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                       "property float z\nend_header\n0 0 0\n1 1 1\n"),
             Contains("make a mesh of them first"));
}

TEST_CASE("an STL is read as text or as numbers by what is in it, not by its first word") {
  const auto box = tests::boxMesh(kHalf);
  checkBox(meshOf("a.stl", tests::stlText(box), MeshUnit::centimetre));
  checkBox(meshOf("a.stl", tests::stlText(box, "a solid facet of life"), MeshUnit::centimetre));
  checkBox(meshOf("a.stl", tests::stlBytes(box, "solid made by a program"), MeshUnit::centimetre));
  checkBox(meshOf("a.stl", tests::stlBytes(box, "COLOR=abcd"), MeshUnit::centimetre));
  std::string loud = tests::stlText(box);
  for (char& letter : loud) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  checkBox(meshOf("a.stl", loud, MeshUnit::centimetre));
  std::string oneLine = tests::stlText(box);
  std::replace(oneLine.begin(), oneLine.end(), '\n', ' ');
  checkBox(meshOf("a.stl", oneLine, MeshUnit::centimetre));
}

TEST_CASE("empty solids of an STL are nothing, and what stands behind its triangles is passed over") {
  const auto box = tests::boxMesh(kHalf);
  const std::string empty = "solid hidden\nendsolid hidden\n";
  checkBox(meshOf("a.stl", empty + tests::stlText(box) + empty, MeshUnit::centimetre));
  CHECK_THAT(problemOf("a.stl", empty), Contains("no faces"));
  for (const std::string& head : {std::string(), std::string("solid made by a program")}) {
    const auto file =
        meshOf("a.stl", tests::stlBytes(box, head) + std::string(7, '\1'), MeshUnit::centimetre);
    checkBox(file);
    CHECK_THAT(file->remark, Contains("7 bytes behind its last triangle"));
  }
  std::string uncounted = tests::stlBytes(box);
  for (std::size_t i = 80; i < 84; ++i) uncounted[i] = '\0';
  checkBox(meshOf("a.stl", uncounted, MeshUnit::centimetre));
}

TEST_CASE("an STL that is cut short says so") {
  const auto box = tests::boxMesh(kHalf);
  const std::string bytes = tests::stlBytes(box);
  CHECK_THAT(problemOf("a.stl", bytes.substr(0, bytes.size() - 60)),
             Contains("cut short") && Contains("12 triangles"));
  const std::string text = tests::stlText(box);
  CHECK_THAT(problemOf("a.stl", text.substr(0, text.size() - 60)), Contains("cut short"));
  CHECK_THAT(problemOf("a.stl", "nonsense"), Contains("no STL"));
}

/// A box as PLY: the numbers of corners and faces as text, or as bytes of either order.
struct PlyBox {
  std::string format = "ascii";
  std::string corner = "float";
  bool asStrip = false;

  std::string make() const {
    const auto box = tests::boxMesh(kHalf);
    std::string text = "ply\nformat " + format +
                       " 1.0\ncomment made by a test\nelement camera 1\nproperty double angle\n" +
                       "property list uchar int numbers\nelement vertex 8\nproperty " + corner +
                       " x\nproperty " + corner + " y\nproperty uchar red\nproperty " + corner + " z\n";
    text +=
        asStrip
            ? "element tristrips 1\nproperty list int int vertex_indices\n"
            : "element face 12\nproperty list uchar uint vertex_indices\nproperty list uchar float other\n";
    text += "end_header\n";
    put<double>(text, 0.5);
    put<std::uint8_t>(text, 2);
    for (const int number : {1, 2}) put<std::int32_t>(text, number);
    for (const Vec3& point : box.points()) {
      putCorner(text, point.x());
      putCorner(text, point.y());
      put<std::uint8_t>(text, 200);
      putCorner(text, point.z());
    }
    asStrip ? putStrip(text, box) : putFaces(text, box);
    return text;
  }

  void putFaces(std::string& text, const sim::TriangleMesh& box) const {
    for (const auto& triangle : box.triangles()) {
      put<std::uint8_t>(text, 3);
      for (const std::uint32_t point : triangle) put<std::uint32_t>(text, point);
      put<std::uint8_t>(text, 1);
      put<float>(text, 1.5F);
    }
  }

  void putStrip(std::string& text, const sim::TriangleMesh& box) const {
    put<std::int32_t>(text, 12 * 4 - 1);
    for (std::size_t t = 0; t < box.triangles().size(); ++t) {
      for (const std::uint32_t point : box.triangles()[t])
        put<std::int32_t>(text, static_cast<std::int32_t>(point));
      if (t + 1 < box.triangles().size()) put<std::int32_t>(text, -1);
    }
  }

  void putCorner(std::string& text, double number) const {
    if (corner == "double") return put<double>(text, number);
    if (corner == "short") return put<std::int16_t>(text, static_cast<std::int16_t>(number));
    put<float>(text, static_cast<float>(number));
  }

  template <class Number>
  void put(std::string& text, Number number) const {
    if (format == "ascii") {
      text += std::to_string(number) + "\n";
      return;
    }
    std::string bytes = tests::bytesOf(std::vector<Number>{number});
    if (format == "binary_big_endian") std::reverse(bytes.begin(), bytes.end());
    text += bytes;
  }
};

TEST_CASE("a PLY is read as text and as bytes of either order, of any types, with what else it has") {
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    for (const char* corner : {"float", "double", "short"}) {
      for (const bool asStrip : {false, true}) {
        INFO(format << ' ' << corner << ' ' << asStrip);
        checkBox(meshOf("a.ply", PlyBox{format, corner, asStrip}.make()));
      }
    }
  }
}

TEST_CASE("strips of triangles in a PLY turn every other one") {
  // A closed ring of a tetrahedron: one strip of four triangles.
  const auto file =
      meshOf("a.ply",
             "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
             "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
             "0 0 0 6 0 0 0 6 0 0 0 6 6 0 1 2 3 0 1\n");
  REQUIRE(file.ok());
  CHECK(file->mesh.closed());
  CHECK(std::abs(file->mesh.volume()) == Approx(36.0));
}

TEST_CASE("a PLY that is cut short, or names what is not there, says so") {
  const std::string whole = PlyBox{"binary_little_endian", "float", false}.make();
  CHECK_THAT(problemOf("a.ply", whole.substr(0, whole.size() - 40)),
             Contains("cut short") && Contains("\"face\""));
  std::string wrong = PlyBox{}.make();
  wrong.replace(wrong.find("property uchar red"), 14, "property uchir");
  CHECK_THAT(problemOf("a.ply", wrong), Contains("line 10") && Contains("type"));
  CHECK_THAT(problemOf("a.ply", "plyx\n"), Contains("no PLY"));
  CHECK_THAT(problemOf("a.ply", "ply\nformat ascii 1.0\n"), Contains("cut short"));
}

TEST_CASE("a file that is not what its name says is called what it is") {
  const std::string text = tests::objText(tests::boxMesh(kHalf));
  std::string twoBytes;
  for (const char letter : text) twoBytes += std::string{letter, '\0'};
  CHECK_THAT(problemOf("a.obj", twoBytes), Contains("UTF-16") && Contains("UTF-8"));
  CHECK_THAT(problemOf("a.obj", "\xff\xfe" + twoBytes), Contains("UTF-16"));
  CHECK_THAT(problemOf("a.obj", std::string("\x1f\x8b\x08\0\0", 5)), Contains("gzip") && Contains("unpack"));
  CHECK_THAT(problemOf("a.stl.gz", "x"), Contains("packed") && Contains("unpack"));
  CHECK_THAT(problemOf("cups.zip", "PK\x03\x04"), Contains("packed") && Contains("unpack"));
  CHECK_THAT(problemOf("a.glb", "PK\x03\x04"), Contains("zip"));
  CHECK_THAT(problemOf("a.stl", PlyBox{}.make()), Contains("this is a PLY file"));
  CHECK_THAT(problemOf("a.obj", "<!DOCTYPE html><p>404"), Contains("page of the web"));
  CHECK_THAT(problemOf("a.obj", ""), Contains("empty"));
  CHECK_THAT(problemOf("a.png", "x"), Contains("no format"));
}

TEST_CASE("a unit that a file states counts, and our own exports state theirs") {
  const auto box = tests::boxMesh(Vec3(40.0, 40.0, 50.0));  // no dish in cm
  const std::string own = "# Smithereens surface, cm, z up\n";
  for (const std::string& statement :
       {own, std::string("# Units: centimeters\n"),
        std::string("# This file uses centimeters as units for non-parametric coordinates.\n")}) {
    INFO(statement);
    const auto file = meshOf("a.obj", statement + tests::objText(box));
    REQUIRE(file.ok());
    CHECK((sizeOf(*file) - Vec3(80.0, 80.0, 100.0)).norm() < kFloat);
    CHECK_THAT(file->remark, Contains("in centimetres") && Contains("as the file states"));
  }
  const auto stl = meshOf("a.stl", tests::stlBytes(box, "binary, units: mm, Y up"));
  REQUIRE(stl.ok());
  CHECK((sizeOf(*stl) - Vec3(8.0, 10.0, 8.0)).norm() < kFloat);
  CHECK_THAT(stl->remark, Contains("in millimetres and with y up, as the file states"));
  // What the scene says goes before.
  const auto said = meshOf("a.obj", own + tests::objText(box), MeshUnit::millimetre, MeshUp::guess);
  REQUIRE(said.ok());
  CHECK((sizeOf(*said) - Vec3(8.0, 8.0, 10.0)).norm() < kFloat);
  CHECK_THAT(said->remark, Contains("the file states centimetres"));
}

TEST_CASE("an STL without a unit is in millimetres first, and the other reading is said") {
  const auto box = tests::boxMesh(Vec3(21.0, 21.0, 20.0));
  const auto stl = meshOf("a.stl", tests::stlBytes(box));
  REQUIRE(stl.ok());
  CHECK((sizeOf(*stl) - Vec3(4.2, 4.2, 4.0)).norm() < kFloat);
  CHECK_THAT(stl->remark,
             Contains("in millimetres by a guess") && Contains("in centimetres it would be 42 x 42 x 40 cm"));
  const auto obj = meshOf("a.obj", tests::objText(box));
  REQUIRE(obj.ok());
  CHECK((sizeOf(*obj) - Vec3(42.0, 42.0, 40.0)).norm() < kFloat);
  CHECK_THAT(obj->remark, Contains("in millimetres it would be 4.2 x 4.2 x 4 cm"));
}

TEST_CASE("a mesh that is no surface, or has a corner far away, is refused with the reason") {
  CHECK_THAT(problemOf("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), Contains("has an area"));
  CHECK_THAT(problemOf("a.obj", "v 1 1 1\nf 1 1 1\nf 1 1 1\n"),
             Contains("none of the 2 faces") && Contains("has an area"));
  CHECK_THAT(problemOf("a.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), Contains("is no number"));
  CHECK_THAT(problemOf("a.obj", "v 1e30 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
             Contains("further than ten kilometres"));
  const std::string ball = tests::objText(tests::ballMesh(4.0, 6));
  CHECK_THAT(problemOf("a.obj", ball + "v 90000 0 0\nf 1 2 -1\n"), Contains("a thousand times as far"));
  CHECK(meshOf("a.obj", ball + "v 90000 0 0\n").ok());
}

}  // namespace
