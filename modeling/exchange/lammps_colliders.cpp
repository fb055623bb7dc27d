#include "modeling/exchange/lammps_colliders.h"

#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

namespace modeling {

namespace {

/// k X + d V with friction, as ours (docs/numerics.md): `h` is the height of a node above the surface, `n`
/// the way out.
void addPush(const std::string& id, const sim::Collider& collider, double step, LammpsText& script) {
  const auto v = [&](const char* name) { return std::string("v_").append(name).append(id); };
  script.variable("k" + id, collider.stiffness ? lammpsNumber(*collider.stiffness) + "+0*x" : "c_contact")
      .variable("e" + id, "(" + v("h") + "<0)*(-" + v("h") + ")*" + v("k"))
      .variable("vn" + id, "vx*" + v("nx") + "+vy*" + v("ny") + "+vz*" + v("nz"))
      .variable("p" + id, "(" + v("h") + "<0)*(" + v("e") + "-" + lammpsNumber(2.0 * collider.dampingRatio) +
                              "*sqrt(" + v("k") + "*mass)*" + v("vn") + ")")
      .variable("q" + id, "(" + v("p") + ">0)*" + v("p"))
      .variable("sx" + id, "vx-" + v("vn") + "*" + v("nx"))
      .variable("sy" + id, "vy-" + v("vn") + "*" + v("ny"))
      .variable("sz" + id, "vz-" + v("vn") + "*" + v("nz"))
      .variable("s" + id, "sqrt(" + v("sx") + "^2+" + v("sy") + "^2+" + v("sz") + "^2)+1e-200")
      .variable("a" + id, lammpsNumber(collider.friction) + "*" + v("e") + "/" + v("s"))
      .variable("b" + id, "mass/" + lammpsNumber(step))
      .variable("c" + id,
                "(" + v("a") + "<" + v("b") + ")*" + v("a") + "+(" + v("a") + ">=" + v("b") + ")*" + v("b"));
  for (const char* const axis : {"x", "y", "z"}) {
    script.variable(std::string("f") + axis + id, v("q") + "*" + v((std::string("n") + axis).c_str()) + "-" +
                                                      v("c") + "*" + v((std::string("s") + axis).c_str()));
  }
  // Formulas are slow: they are evaluated for the nodes inside only.
  script.line("group touching" + id + " dynamic moving region collider" + id + " every 1")
      .line("fix push" + id + " touching" + id + " addforce v_fx" + id + " v_fy" + id + " v_fz" + id);
}

std::string minus(double value) {
  return "-(" + lammpsNumber(value) + ")";
}

/// 1 or -1, as our own colliders take it at 0.
std::string signOf(const std::string& name) {
  return "(1-2*(" + name + "<0))";
}

/// Writes, for each collider, a region with all nodes that may be inside, the height `h` of a node above its
/// surface, negative inside, and the way out there, `nx`, `ny`, `nz`: sim/collider in formulas.
class ColliderFormulas {
 public:
  ColliderFormulas(const sim::Collider& collider, std::string id, LammpsText& script)
      : collider_(collider), id_(std::move(id)), script_(script) {
    const sim::Vec3& at = collider.position;
    from_ = {"(x" + minus(at.x()) + ")", "(y" + minus(at.y()) + ")", "(z" + minus(at.z()) + ")"};
  }

  /// False where there are no formulas for its kind.
  bool add() {
    return std::visit([this](const auto& shape) { return addShape(shape); }, collider_.shape);
  }

 private:
  static constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};

  std::string v(const std::string& name) const { return "v_" + name + id_; }
  void variable(const std::string& name, const std::string& formula) {
    script_.variable(name + id_, formula);
  }
  void ballRegion(double radius) {
    script_.line("region collider" + id_ + " sphere " + lammpsNumbers(collider_.position) + " " +
                 lammpsNumber(radius) + " units box");
  }

  bool addShape(const sim::FloorShape&) {
    const sim::Vec3 normal = collider_.rotation * sim::Vec3::UnitZ();
    for (int axis = 0; axis < 3; ++axis)
      variable(std::string("n") + kAxes[static_cast<std::size_t>(axis)], lammpsNumber(normal[axis]) + "+0*x");
    script_.line("region collider" + id_ + " plane " + lammpsNumbers(collider_.position) + " " +
                 lammpsNumbers(-normal) + " units box");
    variable("h", from_[0] + "*" + v("nx") + "+" + from_[1] + "*" + v("ny") + "+" + from_[2] + "*" + v("nz"));
    return true;
  }

  bool addShape(const sim::SphereShape& sphere) {
    ballRegion(sphere.radius);
    variable("r", "sqrt(" + from_[0] + "^2+" + from_[1] + "^2+" + from_[2] + "^2)+1e-200");
    for (std::size_t axis = 0; axis < 3; ++axis)
      variable(std::string("n") + kAxes[axis], from_[axis] + "/" + v("r"));
    variable("h", v("r") + "-" + lammpsNumber(sphere.radius));
    return true;
  }

  /// A vector of variables, `name` with x, y and z: the matrix times a vector of formulas.
  void addProduct(const std::string& name, const Eigen::Matrix3d& matrix,
                  const std::array<std::string, 3>& vector) {
    for (int axis = 0; axis < 3; ++axis) {
      variable(name + kAxes[static_cast<std::size_t>(axis)],
               lammpsNumber(matrix(axis, 0)) + "*" + vector[0] + "+" + lammpsNumber(matrix(axis, 1)) + "*" +
                   vector[1] + "+" + lammpsNumber(matrix(axis, 2)) + "*" + vector[2]);
    }
  }
  /// Where a node is in the collider's own axes: lx, ly, lz.
  void addLocal() { addProduct("l", collider_.rotation.toRotationMatrix().transpose(), from_); }
  /// The way out, from what it is in the collider's own axes: ox, oy, oz.
  void addNormal() { addProduct("n", collider_.rotation.toRotationMatrix(), {v("ox"), v("oy"), v("oz")}); }

  bool addShape(const sim::BoxShape& box) {
    ballRegion(box.halfSize.norm());
    addLocal();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string name = kAxes[axis];
      variable("d" + name,
               "abs(" + v("l" + name) + ")" + minus(box.halfSize[static_cast<Eigen::Index>(axis)]));
    }
    // Through the nearest side; of equally near ones the first.
    variable("mx", "(" + v("dx") + ">=" + v("dy") + ")*(" + v("dx") + ">=" + v("dz") + ")");
    variable("my", "(1-" + v("mx") + ")*(" + v("dy") + ">=" + v("dz") + ")");
    variable("mz", "1-" + v("mx") + "-" + v("my"));
    variable("h", v("mx") + "*" + v("dx") + "+" + v("my") + "*" + v("dy") + "+" + v("mz") + "*" + v("dz"));
    for (const std::string name : kAxes) variable("o" + name, v("m" + name) + "*" + signOf(v("l" + name)));
    addNormal();
    return true;
  }

  bool addShape(const sim::CylinderShape& cylinder) {
    ballRegion(std::hypot(cylinder.radius, cylinder.halfHeight));
    addLocal();
    variable("r", "sqrt(" + v("lx") + "^2+" + v("ly") + "^2)+1e-200");
    variable("dr", v("r") + minus(cylinder.radius));
    variable("dz", "abs(" + v("lz") + ")" + minus(cylinder.halfHeight));
    variable("mz", "(" + v("dz") + ">" + v("dr") + ")");
    variable("mr", "1-" + v("mz"));
    variable("h", v("mr") + "*" + v("dr") + "+" + v("mz") + "*" + v("dz"));
    variable("ox", v("mr") + "*" + v("lx") + "/" + v("r"));
    variable("oy", v("mr") + "*" + v("ly") + "/" + v("r"));
    variable("oz", v("mz") + "*" + signOf(v("lz")));
    addNormal();
    return true;
  }

  bool addShape(const sim::SurfaceShape&) { return false; }

  const sim::Collider& collider_;
  std::string id_;
  LammpsText& script_;
  std::array<std::string, 3> from_;  ///< a node's place, seen from the collider's
};

}  // namespace

bool hasLammpsFormulas(const sim::Collider& collider) {
  LammpsText scratch;
  return ColliderFormulas(collider, "", scratch).add();
}

void addLammpsCollider(const sim::Collider& collider, const std::string& id, double step,
                       LammpsText& script) {
  if (ColliderFormulas(collider, id, script).add()) addPush(id, collider, step, script);
}

}  // namespace modeling
