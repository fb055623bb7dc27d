#include <algorithm>
#include <cmath>
#include <numbers>

#include "modeling/exchange/lammps_colliders.h"
#include "modeling/exchange/lammps_model.h"
#include "modeling/exchange/lammps_text.h"

namespace modeling {

namespace {

/// A length, or anything that is per length once: lengths are in other units there.
std::string lengthThere(const LammpsModel& model, double cm) {
  return lammpsNumber(model.unitsPerCm * cm);
}

std::string typesWhere(const LammpsModel& model, bool held) {
  std::string list;
  for (std::size_t type = 0; type < model.atomTypes.size(); ++type) {
    if (model.atomTypes[type].held == held) list.append(" ").append(std::to_string(type + 1));
  }
  return list;
}

void addHead(const LammpsModel& model, const std::string& name, LammpsText& script) {
  script
      .line("# Smithereens: a moment of a take for LAMMPS (29 Sep 2021 or later). " +
            (model.unitsPerCm == 1.0 ? "cm" : "1/" + lammpsNumber(model.unitsPerCm) + " cm") +
            ", g, s; z up.")
      .line("#   mpirun -np 4 lmp -in " + name + ".in")
      .line("# where LAMMPS has the BPM package (4 May 2022 or later), nearer to ours by its bonds:")
      .line("#   mpirun -np 4 lmp -var bpm 1 -in " + name + ".in")
      .line("# The result as a take:")
      .line("#   smithereens-cli import-lammps " + name + ".dump --scene SCENE --take OUT.take")
      .line("# It differs from a run of Smithereens in this:");
  for (const std::string& said : lammpsDeviations(model)) script.line("# - " + said + ".");
  script.line("");
}

double largestContact(const LammpsModel& model) {
  double largest = 0.0;
  for (const LammpsAtomType& type : model.atomTypes) largest = std::max(largest, type.contactLength);
  return largest;
}

void addAtoms(const LammpsModel& model, const std::string& name, LammpsText& script) {
  // Bonds that are twice as long as at rest, and some way more until lists are made anew.
  const double furthest = std::max(2.4 * model.longestBond, 2.0 * largestContact(model));
  script.line("variable bpm index 0")
      .line("units lj")
      .line("boundary m m m")
      .line("atom_style hybrid bond sphere")
      // Quartic bonds take away what the pair would push.
      .either(
          {"newton on off", "special_bonds lj 0 1 1 coul 1 1 1"},
          {"newton on on", model.breaks() ? "special_bonds lj/coul 1 1 1" : "special_bonds lj/coul 0 1 1"})
      .line("comm_modify vel yes cutoff " + lengthThere(model, furthest))
      .line("fix constants all property/atom d_contact d_beta ghost no")
      .line("read_data " + name + ".data fix constants NULL Constants");
}

/// A soft spring, as stiff as ours where it begins.
void addContacts(const LammpsModel& model, LammpsText& script) {
  const double touch = largestContact(model);
  const sim::ContactSettings& contact = model.conditions.settings.contact;
  script.line("pair_style soft " + lengthThere(model, touch));
  for (std::size_t i = 0; i < model.atomTypes.size(); ++i) {
    for (std::size_t j = i; j < model.atomTypes.size(); ++j) {
      const LammpsAtomType& one = model.atomTypes[i];
      const LammpsAtomType& other = model.atomTypes[j];
      const double length = model.unitsPerCm * std::min(one.contactLength, other.contactLength);
      const double stiffness =
          contact.between ? contact.stiffnessScale * std::min(one.contactStiffness, other.contactStiffness)
                          : 0.0;
      // E = A (1 + cos(pi r / length)) has the stiffness A (pi / length)^2 where it begins.
      script.line("pair_coeff " + std::to_string(i + 1) + " " + std::to_string(j + 1) + " " +
                  lammpsNumber(stiffness * length * length / (std::numbers::pi * std::numbers::pi)) + " " +
                  lammpsNumber(length));
    }
  }
  script.line("neighbor " + lengthThere(model, 0.3 * touch) + " bin");
  const std::string whenMoved = "neigh_modify every 1 delay 0 check yes";
  const std::string often =
      "neigh_modify every " + std::to_string(LammpsModel::kStepsBetweenLists) + " delay 0 check no";
  script.either({whenMoved}, {model.breaks() ? often : whenMoved});
}

std::string bondTypes(std::size_t first, std::size_t count) {
  const std::string from = std::to_string(first + 1);
  return count == 1 ? from : from + "*" + std::to_string(first + count);
}

/// Bonds that only break: without BPM of the style quartic, with BPM taken away again.
void addBreakingBonds(const LammpsModel& model, std::vector<std::string>& bpm,
                      std::vector<std::string>& without) {
  const std::string all = bondTypes(model.bondTypes.size(), model.breakLengths.size());
  bpm.push_back("bond_coeff " + all + " 0 1 0");
  bpm.push_back("delete_bonds all bond " + all + " remove");
  for (std::size_t i = 0; i < model.breakLengths.size(); ++i)
    without.push_back("bond_coeff " + bondTypes(model.bondTypes.size() + i, 1) + " quartic 0 0 0 " +
                      lengthThere(model, model.breakLengths[i]) + " 0");
}

void addBonds(const LammpsModel& model, LammpsText& script) {
  std::vector<std::string> bpm{"bond_style bpm/spring smooth no break yes"};
  std::vector<std::string> without{model.breaks() ? "bond_style hybrid harmonic quartic"
                                                  : "bond_style harmonic"};
  const std::string style = model.breaks() ? " harmonic " : " ";
  for (std::size_t first = 0; first < model.bondTypes.size();) {
    const LammpsBondType& type = model.bondTypes[first];
    std::size_t next = first;
    for (; next < model.bondTypes.size() && model.bondTypes[next].kind == type.kind; ++next) {
      const LammpsBondType& level = model.bondTypes[next];
      // A stretch by a million breaks nothing.
      const double threshold = std::isfinite(level.threshold) ? level.threshold : 1e6;
      bpm.push_back("bond_coeff " + bondTypes(next, 1) + " " + lammpsNumber(level.stiffness) + " " +
                    lammpsNumber(threshold) + " " + lammpsNumber(level.damping));
    }
    // Harmonic energy is K (r - r0)^2 there.
    without.push_back("bond_coeff " + bondTypes(first, next - first) + style +
                      lammpsNumber(0.5 * type.stiffness) + " " + lengthThere(model, type.restLength));
    first = next;
  }
  if (model.breaks()) addBreakingBonds(model, bpm, without);
  script.either(bpm, without);
}

/// The damping of a node, by the change of what bonds and contacts do to it. When lists are made anew the
/// bonds that broke are gone; such a leap is no motion, so that step has no damping and the others have its
/// share.
std::vector<std::string> damping(const LammpsModel& model) {
  static constexpr double kEvery = LammpsModel::kStepsBetweenLists;
  std::string factor = "c_beta/dt*";
  if (model.breaks())
    factor.append(lammpsNumber(kEvery / (kEvery - 1.0)))
        .append("*((step-" + std::to_string(model.firstStep) + ")%")
        .append(lammpsNumber(kEvery))
        .append("!=0)*");
  std::vector<std::string> lines{"compute beta all property/atom d_beta", "fix elastic all store/force",
                                 "run 0",
                                 "fix before all store/state 1 f_elastic[1] f_elastic[2] f_elastic[3]"};
  for (const std::string axis : {"x1", "y2", "z3"}) {
    std::string line = "variable damp";
    line.append(1, axis[0]).append(" atom \"").append(factor).append("(f_elastic[").append(1, axis[1]);
    lines.push_back(line.append("]-f_before[").append(1, axis[1]).append("])\""));
  }
  lines.emplace_back("fix damping moving addforce v_dampx v_dampy v_dampz");
  return lines;
}

void addMotion(const LammpsModel& model, LammpsText& script) {
  const std::string held = typesWhere(model, true);
  const std::string moving = typesWhere(model, false);
  script.line("timestep " + lammpsNumber(model.step));
  if (model.firstStep != 0) script.line("reset_timestep " + std::to_string(model.firstStep));
  if (!held.empty()) script.line("group held type" + held).line("fix heldAsTheyAre held nve/noforce");
  script.line("group moving type" + (moving.empty() ? " 1" : moving)).line("fix motion moving nve");
  // What bonds and contacts do, before anything else is added; its change is what damping hangs on.
  script.either({}, damping(model));
  const Vec3& gravity = model.conditions.environment.gravity;
  if (gravity.norm() > 0.0)
    script.line("fix gravity moving gravity " + lengthThere(model, gravity.norm()) + " vector " +
                lammpsNumbers(gravity));
}

sim::Collider inTheirUnits(sim::Collider collider, double unitsPerCm) {
  collider.position *= unitsPerCm;
  const Vec3 factors = Vec3::Constant(unitsPerCm);
  std::visit(
      [&](auto& shape) {
        if constexpr (requires { shape.scale(factors); }) shape.scale(factors);
      },
      collider.shape);
  return collider;
}

void addColliders(const LammpsModel& model, LammpsText& script) {
  script.line("compute contact all property/atom d_contact");
  int count = 0;
  for (const sim::Collider& collider : model.conditions.environment.colliders) {
    const std::string id = std::to_string(++count);
    addLammpsCollider(inTheirUnits(collider, model.unitsPerCm), id, model.step, script);
  }
}

void addRun(const LammpsModel& model, const std::string& name, LammpsText& script) {
  const std::string every = std::to_string(model.stepsPerFrame);
  const bool otherUnits = model.unitsPerCm != 1.0;
  // What a unit of length is, for who reads the dump: LAMMPS has no place for it but a column.
  if (otherUnits) script.line("variable cm atom " + lammpsNumber(1.0 / model.unitsPerCm) + "+0*x");
  script
      .line("dump nodes all custom " + every + " " + name + ".dump id x y z vx vy vz" +
            (otherUnits ? " v_cm" : ""))
      .line("dump_modify nodes time yes sort id format float %.17g")
      .line("compute pairs all property/local batom1 batom2")
      .line("dump bonds all local " + every + " " + name + ".bonds c_pairs[1] c_pairs[2]")
      .line("thermo " + every)
      .line("thermo_modify lost warn flush yes")
      .line("run " + std::to_string(model.stepsPerFrame * model.frames));
}

}  // namespace

std::string lammpsScript(const LammpsModel& model, const std::string& name) {
  LammpsText script;
  addHead(model, name, script);
  addAtoms(model, name, script);
  addContacts(model, script);
  addBonds(model, script);
  addMotion(model, script);
  addColliders(model, script);
  addRun(model, name, script);
  return script.text();
}

}  // namespace modeling
