#pragma once

#include <string>
#include <vector>

#include "modeling/exchange/export.h"
#include "modeling/scene/build.h"

/// What LAMMPS is given of a moment of a take, and what of it LAMMPS cannot do.
namespace modeling {

struct LammpsBondType {
  double stiffness = 0.0;                ///< k, dyn/cm
  double restLength = 0.0;               ///< cm
  double damping = 0.0;                  ///< g/s
  double threshold = sim::kUnbreakable;  ///< relative stretch
};

/// Atoms of one material; held ones are a type of their own.
struct LammpsAtomType {
  sim::MaterialIndex material = 0;
  bool held = false;
  double contactLength = 0.0;     ///< cm: median of the nodes' radii
  double contactStiffness = 0.0;  ///< dyn/cm: median of the nodes' weakest bonds
};

/// Of LAMMPS 2021 and later, whose bonds have a type each. A type is a class of bonds and a level of their
/// thresholds, which are drawn for each bond: so many levels that there are at most kMostBreakingTypes, since
/// each costs a search through all bonds.
struct LammpsModel {
  static constexpr std::size_t kMostBreakingTypes = 240;
  static constexpr std::size_t kMostLevels = 32;

  const sim::Network* network = nullptr;
  sim::SnapshotPointer moment;
  Conditions conditions;
  std::vector<LammpsBondType> bondTypes;
  std::vector<std::uint32_t> typeOfBond;  ///< from 0; one a bond of the network, broken ones too
  std::vector<LammpsAtomType> atomTypes;
  std::vector<std::uint32_t> typeOfNode;  ///< from 0
  std::vector<double> contactStiffness;   ///< one a node: its weakest bond, dyn/cm
  std::vector<double> dampingTime;        ///< one a node: mean d / k of its bonds, s
  double thresholdRounding = 0.0;         ///< largest relative change that levels made
  double longestBond = 0.0;               ///< cm
  double step = 0.0;                      ///< s; a whole number of them is a frame
  std::uint64_t stepsPerFrame = 1;
  std::uint64_t frames = 1;  ///< after the first, up to the scene's duration

  bool bondIsWhole(sim::BondIndex bond) const { return !moment->broken->hasLostBond(bond); }
};

/// The take's first requested frame, and the conditions of the scene it came from.
sim::Result<LammpsModel> lammpsModel(const sim::TakeReader& take, const ExportRequest& request);

/// What the run will do otherwise than ours, a sentence each.
std::vector<std::string> lammpsDeviations(const LammpsModel& model);

/// The input script, which reads `data`.
std::string lammpsScript(const LammpsModel& model, const std::string& name);

}  // namespace modeling
