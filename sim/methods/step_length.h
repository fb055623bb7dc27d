#pragma once

#include <limits>

#include "sim/base/bytes.h"
#include "sim/methods/method_table.h"
#include "sim/methods/spectrum.h"
#include "sim/methods/step_limit.h"
#include "sim/state/settings.h"

namespace sim {

/// Works out how long the next step may be, and what limits it. It is fed numbers and knows no world. Of the
/// methods with a tolerance it also judges the steps that were made (docs/numerics.md, "Tolerance").
class StepLength {
 public:
  StepLength(const Settings& settings, const Spectrum& spectrum);

  /// What a choice follows from, beside the settings.
  struct Scene {
    double stiffnessScale = 1.0;      ///< largest of the materials', as tracks make it
    double dampingScale = 1.0;        ///< largest of the materials', as tracks make it
    bool latticeMoves = true;         ///< some bond is evaluated
    double contactRateSquared = 0.0;  ///< 1/s^2, see Stiffest
    double contactDamping = 0.0;      ///< 1/s
    double speed = 0.0;               ///< cm/s: no node is faster
    double longestTravel = std::numeric_limits<double>::infinity();  ///< cm: how far a node may go in a step
  };
  /// The next step, s, where this one was wanted before (0: none was). Zero where no step is stable. An
  /// automatic step grows only when it may by a tenth, since every change costs Verlet its symmetry in time.
  double choose(const Scene& scene, double wanted);
  /// Of a step of `step` s, as last chosen, with these scales of the materials.
  StepLimit limit(double stiffnessScale, double dampingScale, double step) const;
  /// s: the longest fixed step that is stable where nothing touches
  double longestFixed() const { return longestFixed_; }
  /// The last choice counted the lattice in.
  bool countsLattice() const { return latticeCounts_; }
  /// The scene was restored: the lattice counts as it does now.
  void setCountsLattice(bool counts) { latticeCounts_ = counts; }

  bool hasTolerance() const { return settings_.tolerance.has_value(); }
  /// 1/s: of the shortest swing of bonds
  double stiffestRate(double stiffnessScale) const;
  /// Methods that cannot take a step back begin with one that surely is short enough.
  void beginSurely(double stiffnessScale);
  /// How wrong a step was, root mean squares over bonds (see StrainError), and how long it was, s.
  struct Made {
    double error = 0.0;
    double strain = 0.0;
    double length = 0.0;
  };
  /// A step that stands: the next ones follow its error. `elapsed`: s, since a step was looked at.
  void follow(const Made& made, double elapsed, double stiffnessScale);
  /// Whether a step was as exact as the tolerance asks for. If so the next ones follow its error; else
  /// `length` (s) becomes that of another attempt.
  bool accepts(const Made& made, double& length, double stiffnessScale);
  /// The wanted step (s) is longer than tolerated.
  bool exceeds(double wanted) const { return toleratedStep_ < wanted; }

  void save(ByteWriter& writer) const;
  /// False where the bytes cannot have come from save().
  bool load(ByteReader& reader);
  /// Goes on from another one of the same network: the largest strain so far is its.
  void takeOver(const StepLength& other);

 private:
  double partOfFixed(const Stiffening& stiffening);
  double latticeStiffness(double stiffnessScale) const;
  double shortestTolerated(double stiffnessScale) const;
  double longestTolerated(const Made& made, double stiffnessScale);
  void aimFor(double longest, double elapsed, double stiffnessScale);

  static constexpr double kAnyStep = 1.0;

  Settings settings_;
  Spectrum spectrum_;
  bool latticeCounts_ = true;
  double longestFixed_ = std::numeric_limits<double>::infinity();
  double toleratedStep_ = kAnyStep;  ///< s: the longest that keeps to the tolerance, as far as it is known
  double largestStrain_ = 0.0;  ///< root mean square over bonds, the largest so far; with a tolerance only
};

}  // namespace sim
