#pragma once

#include <string>
#include <vector>

#include "modeling/exchange/export.h"
#include "modeling/scene/build.h"

/// What LAMMPS is given of a moment of a take, and what of it LAMMPS cannot do.
namespace modeling {

/// A spring. Bonds of one kind, which agree in stiffness, rest length and damping, have types that follow
/// each other, one a level of their thresholds.
struct LammpsBondType {
  double stiffness = 0.0;                ///< k, dyn/cm
  double restLength = 0.0;               ///< cm
  double damping = 0.0;                  ///< g/s
  double threshold = sim::kUnbreakable;  ///< relative stretch: mean of the level's bonds
  std::uint32_t kind = 0;                ///< of types of one kind the same number
};

/// Atoms of one material that are about equally large and stiff; held ones are types of their own.
struct LammpsAtomType {
  sim::MaterialIndex material = 0;
  bool held = false;
  double contactLength = 0.0;     ///< cm: the smallest of its nodes'
  double contactStiffness = 0.0;  ///< dyn/cm: the least of its nodes'
};

/// What is lost of the bonds' thresholds t, since LAMMPS has them by types.
struct ThresholdRounding {
  double largest = 0.0;          ///< largest relative change of a bond's t
  double spread = 0.0;           ///< standard deviation of ours, relative to their material's mean
  double spreadThere = 0.0;      ///< and of those in LAMMPS
  double largestOfLevels = 0.0;  ///< largest relative change by the levels, which BPM breaks by
};

/// What LAMMPS is given. Without BPM, a pair of nodes that may part has two bonds: a harmonic one, of a type
/// of `bondTypes`, and one of the style "quartic" with no force, of a type that stands for a length of
/// `breakLengths`. Where a quartic bond gets longer than that, LAMMPS takes all bonds of the pair away. That
/// is one test a bond and step, however many types there are; fix bond/break searches all bonds for each
/// type.
struct LammpsModel {
  /// So few that LAMMPS reads them in a second.
  static constexpr std::size_t kMostBreakLengths = 20000;
  /// A harmonic bond whose pair has parted still pulls until LAMMPS makes its lists anew, every so many
  /// steps.
  static constexpr int kStepsBetweenLists = 5;

  const sim::Network* network = nullptr;
  sim::SnapshotPointer moment;
  Conditions conditions;
  std::vector<LammpsBondType> bondTypes;
  std::vector<std::uint32_t> typeOfBond;   ///< from 0; one a bond of the network, broken ones too
  std::vector<double> breakLengths;        ///< cm, ascending
  std::vector<std::uint32_t> breakOfBond;  ///< from 0, one a bond; kNone: it never breaks
  std::vector<LammpsAtomType> atomTypes;
  std::vector<std::uint32_t> typeOfNode;  ///< from 0
  std::vector<double> contactStiffness;   ///< one a node: its weakest bond, dyn/cm
  std::vector<double> contactLength;      ///< one a node, cm
  std::vector<double> dampingTime;        ///< one a node: mean d / k of its bonds, s
  ThresholdRounding rounding;
  double longestBond = 0.0;  ///< cm, at rest
  /// LAMMPS' units of length in a centimetre, a power of two, so that no digit is lost. Its quartic bonds
  /// also push below a length of 1.12 units, which bonds must stay far above; 1 where nothing breaks.
  double unitsPerCm = 1.0;
  double step = 0.0;  ///< s; a whole number of them is a frame
  std::uint64_t stepsPerFrame = 1;
  std::uint64_t firstStep = 0;  ///< number of the step that it begins with, by which frame it is
  std::uint64_t frames = 1;     ///< after the first, up to the scene's duration

  bool bondIsWhole(sim::BondIndex bond) const { return !moment->broken->hasLostBond(bond); }
  bool breaks() const { return !breakLengths.empty(); }
};

/// The take's first requested frame, and the conditions of the scene it came from.
sim::Result<LammpsModel> lammpsModel(const sim::TakeReader& take, const ExportRequest& request);

/// What the run will do otherwise than ours, a sentence each.
std::vector<std::string> lammpsDeviations(const LammpsModel& model);

/// Of lammpsModel(): the types of bonds, of a network that is there already.
void addBondTypes(LammpsModel& model);
/// Of lammpsModel(): what is asked of nodes, and their types. No two nodes push at the moment that is
/// exported, nor when a bond between them breaks, so that neither makes motion: a node's contact length is at
/// most that of its shortest bond, and the way to the nearest node that it is not bonded to.
void addAtomTypes(LammpsModel& model);

/// The input script, which reads `data`.
std::string lammpsScript(const LammpsModel& model, const std::string& name);

}  // namespace modeling
