#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <Eigen/Geometry>

#include "modeling/exchange/lammps_model.h"

namespace modeling {

namespace {

/// Bonds are looked at for breaking so often that all searches together cost about as much as eight in every
/// step.
constexpr std::size_t kSearchesPerStep = 8;

std::string number(double value) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

std::string spaced(const Vec3& vector) {
  return number(vector.x()) + " " + number(vector.y()) + " " + number(vector.z());
}

class Script {
 public:
  Script& line(const std::string& text) {
    text_ += text + "\n";
    return *this;
  }
  /// An atom-style variable.
  Script& variable(const std::string& name, const std::string& formula) {
    return line("variable " + name + " atom \"" + formula + "\"");
  }
  /// What is done by builds with the BPM package, and by those without.
  Script& either(const std::vector<std::string>& bpm, const std::vector<std::string>& without) {
    const std::string end = "end" + std::to_string(++jumps_);
    const std::string other = "without" + std::to_string(jumps_);
    line("if \"${bpm} == 0\" then \"jump SELF " + other + "\"");
    for (const std::string& command : bpm) line(command);
    line("jump SELF " + end).line("label " + other);
    for (const std::string& command : without) line(command);
    return line("label " + end);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  int jumps_ = 0;
};

std::string typesWhere(const LammpsModel& model, bool held) {
  std::string list;
  for (std::size_t type = 0; type < model.atomTypes.size(); ++type) {
    if (model.atomTypes[type].held == held) list.append(" ").append(std::to_string(type + 1));
  }
  return list;
}

void addHead(const LammpsModel& model, const std::string& name, Script& script) {
  script.line("# Smithereens: a moment of a take for LAMMPS (29 Sep 2021 or later). cm, g, s; z up.")
      .line("#   mpirun -np 4 lmp -in " + name + ".in")
      .line("# where LAMMPS has the BPM package (4 May 2022 or later), nearer to ours by its bonds:")
      .line("#   mpirun -np 4 lmp -var bpm 1 -in " + name + ".in")
      .line("# The result as a take:")
      .line("#   smithereens-cli import-lammps " + name + ".dump --scene SCENE --take OUT.take")
      .line("# It differs from a run of Smithereens in this:");
  for (const std::string& said : lammpsDeviations(model)) script.line("# - " + said + ".");
  script.line("");
}

/// fix bond/break keeps lists of what is one, two and three bonds away, but counts on room for the first only
/// where nothing else asks for the others: more, and it writes past their ends. In a lattice of cells 26
/// nodes are one bond away and 342 three.
std::size_t roomForBreaking(const LammpsModel& model) {
  static constexpr std::size_t kRoomPerBond = 16;
  const sim::Network& network = *model.network;
  std::vector<std::size_t> bonds(network.nodeCount(), 0);
  bool breaks = false;
  for (sim::NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (sim::BondIndex bond = network.firstBond[a]; bond < network.firstBond[a + 1]; ++bond) {
      ++bonds[a];
      ++bonds[network.bondEnds[bond]];
      breaks = breaks || std::isfinite(network.thresholds[bond]);
    }
  }
  return breaks ? kRoomPerBond * *std::max_element(bonds.begin(), bonds.end()) : 0;
}

void addAtoms(const LammpsModel& model, const std::string& name, Script& script) {
  double touch = 0.0;
  for (const LammpsAtomType& type : model.atomTypes) touch = std::max(touch, type.contactLength);
  script.line("variable bpm index 0")
      .line("units lj")
      .line("boundary m m m")
      .line("atom_style hybrid bond sphere")
      .either({"newton on off", "special_bonds lj 0 1 1 coul 1 1 1"},
              {"newton on on", "special_bonds lj/coul 0 1 1"})
      .line("comm_modify vel yes cutoff " + number(std::max(2.0 * model.longestBond, 2.0 * touch)))
      .line("fix constants all property/atom d_contact d_beta ghost no")
      .either({"variable room index 0"}, {"variable room index " + std::to_string(roomForBreaking(model))})
      .line("read_data " + name + ".data fix constants NULL Constants extra/special/per/atom ${room}")
      .line("pair_style soft " + number(touch));
  for (std::size_t i = 0; i < model.atomTypes.size(); ++i) {
    for (std::size_t j = i; j < model.atomTypes.size(); ++j) {
      const double length = std::min(model.atomTypes[i].contactLength, model.atomTypes[j].contactLength);
      const double stiffness =
          std::min(model.atomTypes[i].contactStiffness, model.atomTypes[j].contactStiffness) *
          model.conditions.settings.contact.stiffnessScale;
      // E = A (1 + cos(pi r / length)) has the stiffness A (pi / length)^2 where it begins.
      const double energy =
          model.conditions.settings.contact.between ? stiffness * length * length / 9.869604401089358 : 0.0;
      script.line("pair_coeff " + std::to_string(i + 1) + " " + std::to_string(j + 1) + " " + number(energy) +
                  " " + number(length));
    }
  }
  script.line("neighbor " + number(0.3 * touch) + " bin").line("neigh_modify every 1 delay 0 check yes");
}

void addBonds(const LammpsModel& model, Script& script) {
  std::vector<std::string> bpm{"bond_style bpm/spring smooth no break yes"};
  std::vector<std::string> harmonic{"bond_style harmonic"};
  for (std::size_t i = 0; i < model.bondTypes.size(); ++i) {
    const LammpsBondType& type = model.bondTypes[i];
    const std::string start = "bond_coeff " + std::to_string(i + 1) + " ";
    // A stretch by a million breaks nothing. Harmonic energy is K (r - r0)^2 there.
    const double threshold = std::isfinite(type.threshold) ? type.threshold : 1e6;
    bpm.push_back(start + number(type.stiffness) + " " + number(threshold) + " " + number(type.damping));
    harmonic.push_back(start + number(0.5 * type.stiffness) + " " + number(type.restLength));
  }
  script.either(bpm, harmonic);
}

void addMotion(const LammpsModel& model, Script& script) {
  const std::string held = typesWhere(model, true);
  const std::string moving = typesWhere(model, false);
  script.line("timestep " + number(model.step));
  if (!held.empty()) script.line("group held type" + held).line("fix heldAsTheyAre held nve/noforce");
  script.line("group moving type" + (moving.empty() ? " 1" : moving)).line("fix motion moving nve");
  // What bonds and contacts do, before anything else is added; its change is what damping hangs on.
  script.either({}, {"compute beta all property/atom d_beta", "fix elastic all store/force", "run 0",
                     "fix before all store/state 1 f_elastic[1] f_elastic[2] f_elastic[3]",
                     "variable dampx atom \"c_beta/dt*(f_elastic[1]-f_before[1])\"",
                     "variable dampy atom \"c_beta/dt*(f_elastic[2]-f_before[2])\"",
                     "variable dampz atom \"c_beta/dt*(f_elastic[3]-f_before[3])\"",
                     "fix damping moving addforce v_dampx v_dampy v_dampz"});
  const Vec3& gravity = model.conditions.environment.gravity;
  if (gravity.norm() > 0.0)
    script.line("fix gravity moving gravity " + number(gravity.norm()) + " vector " + spaced(gravity));
}

/// k X + d V with friction, as in docs/numerics.md, Contact 5 and Contact 6: `h` is the height of a node
/// above the surface, `n` the way out.
void addPush(const std::string& id, const sim::Collider& collider, double step, Script& script) {
  const auto v = [&](const char* name) { return std::string("v_").append(name).append(id); };
  script.variable("k" + id, collider.stiffness ? number(*collider.stiffness) + "+0*x" : "c_contact")
      .variable("e" + id, "(" + v("h") + "<0)*(-" + v("h") + ")*" + v("k"))
      .variable("vn" + id, "vx*" + v("nx") + "+vy*" + v("ny") + "+vz*" + v("nz"))
      .variable("p" + id, "(" + v("h") + "<0)*(" + v("e") + "-" + number(2.0 * collider.dampingRatio) +
                              "*sqrt(" + v("k") + "*mass)*" + v("vn") + ")")
      .variable("q" + id, "(" + v("p") + ">0)*" + v("p"))
      .variable("sx" + id, "vx-" + v("vn") + "*" + v("nx"))
      .variable("sy" + id, "vy-" + v("vn") + "*" + v("ny"))
      .variable("sz" + id, "vz-" + v("vn") + "*" + v("nz"))
      .variable("s" + id, "sqrt(" + v("sx") + "^2+" + v("sy") + "^2+" + v("sz") + "^2)+1e-200")
      .variable("a" + id, number(collider.friction) + "*" + v("e") + "/" + v("s"))
      .variable("b" + id, "mass/" + number(step))
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
  return "-(" + number(value) + ")";
}

/// 1 or -1, as our own colliders take it at 0.
std::string signOf(const std::string& name) {
  return "(1-2*(" + name + "<0))";
}

/// Writes, for each collider, a region with all nodes that may be inside, the height `h` of a node above its
/// surface, negative inside, and the way out there, `nx`, `ny`, `nz`: sim/collider/collider.cpp in formulas.
class ColliderFormulas {
 public:
  ColliderFormulas(const sim::Collider& collider, std::string id, Script& script)
      : collider_(collider), id_(std::move(id)), script_(script) {
    const Vec3& at = collider.position;
    from_ = {"(x" + minus(at.x()) + ")", "(y" + minus(at.y()) + ")", "(z" + minus(at.z()) + ")"};
  }

  /// False: a mesh, for which there is no formula.
  bool add() {
    switch (collider_.shape) {
      case sim::ColliderShape::floor:
        addFloor();
        break;
      case sim::ColliderShape::sphere:
        addSphere();
        break;
      case sim::ColliderShape::box:
        addBox();
        break;
      case sim::ColliderShape::cylinder:
        addCylinder();
        break;
      case sim::ColliderShape::mesh:
        return false;
    }
    return true;
  }

 private:
  static constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};

  std::string v(const std::string& name) const { return "v_" + name + id_; }
  void variable(const std::string& name, const std::string& formula) {
    script_.variable(name + id_, formula);
  }
  void ballRegion(double radius) {
    script_.line("region collider" + id_ + " sphere " + spaced(collider_.position) + " " + number(radius) +
                 " units box");
  }

  void addFloor() {
    const Vec3 normal = collider_.rotation * Vec3::UnitZ();
    for (int axis = 0; axis < 3; ++axis)
      variable(std::string("n") + kAxes[static_cast<std::size_t>(axis)], number(normal[axis]) + "+0*x");
    script_.line("region collider" + id_ + " plane " + spaced(collider_.position) + " " + spaced(-normal) +
                 " units box");
    variable("h", from_[0] + "*" + v("nx") + "+" + from_[1] + "*" + v("ny") + "+" + from_[2] + "*" + v("nz"));
  }

  void addSphere() {
    ballRegion(collider_.radius);
    variable("r", "sqrt(" + from_[0] + "^2+" + from_[1] + "^2+" + from_[2] + "^2)+1e-200");
    for (std::size_t axis = 0; axis < 3; ++axis)
      variable(std::string("n") + kAxes[axis], from_[axis] + "/" + v("r"));
    variable("h", v("r") + "-" + number(collider_.radius));
  }

  /// A vector of variables, `name` with x, y and z: the matrix times a vector of formulas.
  void addProduct(const std::string& name, const Eigen::Matrix3d& matrix,
                  const std::array<std::string, 3>& vector) {
    for (int axis = 0; axis < 3; ++axis) {
      variable(name + kAxes[static_cast<std::size_t>(axis)],
               number(matrix(axis, 0)) + "*" + vector[0] + "+" + number(matrix(axis, 1)) + "*" + vector[1] +
                   "+" + number(matrix(axis, 2)) + "*" + vector[2]);
    }
  }
  /// Where a node is in the collider's own axes: lx, ly, lz.
  void addLocal() { addProduct("l", collider_.rotation.toRotationMatrix().transpose(), from_); }
  /// The way out, from what it is in the collider's own axes: ox, oy, oz.
  void addNormal() { addProduct("n", collider_.rotation.toRotationMatrix(), {v("ox"), v("oy"), v("oz")}); }

  void addBox() {
    ballRegion(collider_.halfSize.norm());
    addLocal();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string name = kAxes[axis];
      variable("d" + name,
               "abs(" + v("l" + name) + ")" + minus(collider_.halfSize[static_cast<Eigen::Index>(axis)]));
    }
    // Through the nearest side; of equally near ones the first.
    variable("mx", "(" + v("dx") + ">=" + v("dy") + ")*(" + v("dx") + ">=" + v("dz") + ")");
    variable("my", "(1-" + v("mx") + ")*(" + v("dy") + ">=" + v("dz") + ")");
    variable("mz", "1-" + v("mx") + "-" + v("my"));
    variable("h", v("mx") + "*" + v("dx") + "+" + v("my") + "*" + v("dy") + "+" + v("mz") + "*" + v("dz"));
    for (const std::string name : kAxes) variable("o" + name, v("m" + name) + "*" + signOf(v("l" + name)));
    addNormal();
  }

  void addCylinder() {
    ballRegion(std::hypot(collider_.radius, collider_.halfHeight));
    addLocal();
    variable("r", "sqrt(" + v("lx") + "^2+" + v("ly") + "^2)+1e-200");
    variable("dr", v("r") + minus(collider_.radius));
    variable("dz", "abs(" + v("lz") + ")" + minus(collider_.halfHeight));
    variable("mz", "(" + v("dz") + ">" + v("dr") + ")");
    variable("mr", "1-" + v("mz"));
    variable("h", v("mr") + "*" + v("dr") + "+" + v("mz") + "*" + v("dz"));
    variable("ox", v("mr") + "*" + v("lx") + "/" + v("r"));
    variable("oy", v("mr") + "*" + v("ly") + "/" + v("r"));
    variable("oz", v("mz") + "*" + signOf(v("lz")));
    addNormal();
  }

  const sim::Collider& collider_;
  std::string id_;
  Script& script_;
  std::array<std::string, 3> from_;  ///< a node's place, seen from the collider's
};

void addColliders(const LammpsModel& model, Script& script) {
  script.line("compute contact all property/atom d_contact");
  int count = 0;
  for (const sim::Collider& collider : model.conditions.environment.colliders) {
    const std::string id = std::to_string(++count);
    if (ColliderFormulas(collider, id, script).add()) addPush(id, collider, model.step, script);
  }
}

void addBreaking(const LammpsModel& model, Script& script) {
  std::size_t breaking = 0;
  for (const LammpsBondType& type : model.bondTypes) breaking += std::isfinite(type.threshold) ? 1 : 0;
  const std::size_t every = std::max<std::size_t>(1, breaking / kSearchesPerStep);
  std::vector<std::string> fixes;
  for (std::size_t i = 0; i < model.bondTypes.size(); ++i) {
    const LammpsBondType& type = model.bondTypes[i];
    if (!std::isfinite(type.threshold)) continue;
    const std::string name = std::to_string(i + 1);
    fixes.push_back("fix break" + name + " all bond/break " + std::to_string(every) + " " + name + " " +
                    number(type.restLength * (1.0 + type.threshold)));
  }
  if (!fixes.empty()) script.either({}, fixes);
}

void addRun(const LammpsModel& model, const std::string& name, Script& script) {
  const std::string every = std::to_string(model.stepsPerFrame);
  script.line("dump nodes all custom " + every + " " + name + ".dump id x y z vx vy vz")
      .line("dump_modify nodes time yes sort id format float %.17g")
      .line("compute pairs all property/local batom1 batom2")
      .line("dump bonds all local " + every + " " + name + ".bonds c_pairs[1] c_pairs[2]")
      .line("thermo " + every)
      .line("thermo_modify lost warn flush yes")
      .line("run " + std::to_string(model.stepsPerFrame * model.frames));
}

}  // namespace

std::string lammpsScript(const LammpsModel& model, const std::string& name) {
  Script script;
  addHead(model, name, script);
  addAtoms(model, name, script);
  addBonds(model, script);
  addMotion(model, script);
  addColliders(model, script);
  addBreaking(model, script);
  addRun(model, name, script);
  return script.text();
}

}  // namespace modeling
