#include <algorithm>
#include <cmath>

#include "modeling/exchange/lammps_colliders.h"
#include "modeling/exchange/lammps_model.h"
#include "modeling/exchange/lammps_text.h"

namespace modeling {

namespace {

/// Bonds are looked at for breaking so often that all searches together cost about as much as eight in every
/// step.
constexpr std::size_t kSearchesPerStep = 8;

std::string typesWhere(const LammpsModel& model, bool held) {
  std::string list;
  for (std::size_t type = 0; type < model.atomTypes.size(); ++type) {
    if (model.atomTypes[type].held == held) list.append(" ").append(std::to_string(type + 1));
  }
  return list;
}

void addHead(const LammpsModel& model, const std::string& name, LammpsText& script) {
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

void addAtoms(const LammpsModel& model, const std::string& name, LammpsText& script) {
  double touch = 0.0;
  for (const LammpsAtomType& type : model.atomTypes) touch = std::max(touch, type.contactLength);
  script.line("variable bpm index 0")
      .line("units lj")
      .line("boundary m m m")
      .line("atom_style hybrid bond sphere")
      .either({"newton on off", "special_bonds lj 0 1 1 coul 1 1 1"},
              {"newton on on", "special_bonds lj/coul 0 1 1"})
      .line("comm_modify vel yes cutoff " + lammpsNumber(std::max(2.0 * model.longestBond, 2.0 * touch)))
      .line("fix constants all property/atom d_contact d_beta ghost no")
      .either({"variable room index 0"}, {"variable room index " + std::to_string(roomForBreaking(model))})
      .line("read_data " + name + ".data fix constants NULL Constants extra/special/per/atom ${room}")
      .line("pair_style soft " + lammpsNumber(touch));
  for (std::size_t i = 0; i < model.atomTypes.size(); ++i) {
    for (std::size_t j = i; j < model.atomTypes.size(); ++j) {
      const double length = std::min(model.atomTypes[i].contactLength, model.atomTypes[j].contactLength);
      const double stiffness =
          std::min(model.atomTypes[i].contactStiffness, model.atomTypes[j].contactStiffness) *
          model.conditions.settings.contact.stiffnessScale;
      // E = A (1 + cos(pi r / length)) has the stiffness A (pi / length)^2 where it begins.
      const double energy =
          model.conditions.settings.contact.between ? stiffness * length * length / 9.869604401089358 : 0.0;
      script.line("pair_coeff " + std::to_string(i + 1) + " " + std::to_string(j + 1) + " " +
                  lammpsNumber(energy) + " " + lammpsNumber(length));
    }
  }
  script.line("neighbor " + lammpsNumber(0.3 * touch) + " bin")
      .line("neigh_modify every 1 delay 0 check yes");
}

void addBonds(const LammpsModel& model, LammpsText& script) {
  std::vector<std::string> bpm{"bond_style bpm/spring smooth no break yes"};
  std::vector<std::string> harmonic{"bond_style harmonic"};
  for (std::size_t i = 0; i < model.bondTypes.size(); ++i) {
    const LammpsBondType& type = model.bondTypes[i];
    const std::string start = "bond_coeff " + std::to_string(i + 1) + " ";
    // A stretch by a million breaks nothing. Harmonic energy is K (r - r0)^2 there.
    const double threshold = std::isfinite(type.threshold) ? type.threshold : 1e6;
    bpm.push_back(start + lammpsNumber(type.stiffness) + " " + lammpsNumber(threshold) + " " +
                  lammpsNumber(type.damping));
    harmonic.push_back(start + lammpsNumber(0.5 * type.stiffness) + " " + lammpsNumber(type.restLength));
  }
  script.either(bpm, harmonic);
}

void addMotion(const LammpsModel& model, LammpsText& script) {
  const std::string held = typesWhere(model, true);
  const std::string moving = typesWhere(model, false);
  script.line("timestep " + lammpsNumber(model.step));
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
    script.line("fix gravity moving gravity " + lammpsNumber(gravity.norm()) + " vector " +
                lammpsNumbers(gravity));
}

void addColliders(const LammpsModel& model, LammpsText& script) {
  script.line("compute contact all property/atom d_contact");
  int count = 0;
  for (const sim::Collider& collider : model.conditions.environment.colliders) {
    const std::string id = std::to_string(++count);
    addLammpsCollider(collider, id, model.step, script);
  }
}

void addBreaking(const LammpsModel& model, LammpsText& script) {
  std::size_t breaking = 0;
  for (const LammpsBondType& type : model.bondTypes) breaking += std::isfinite(type.threshold) ? 1 : 0;
  const std::size_t every = std::max<std::size_t>(1, breaking / kSearchesPerStep);
  std::vector<std::string> fixes;
  for (std::size_t i = 0; i < model.bondTypes.size(); ++i) {
    const LammpsBondType& type = model.bondTypes[i];
    if (!std::isfinite(type.threshold)) continue;
    const std::string name = std::to_string(i + 1);
    fixes.push_back("fix break" + name + " all bond/break " + std::to_string(every) + " " + name + " " +
                    lammpsNumber(type.restLength * (1.0 + type.threshold)));
  }
  if (!fixes.empty()) script.either({}, fixes);
}

void addRun(const LammpsModel& model, const std::string& name, LammpsText& script) {
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
  LammpsText script;
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
