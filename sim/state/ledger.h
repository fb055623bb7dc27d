#pragma once

#include <limits>

#include "sim/base/bytes.h"
#include "sim/network/network.h"
#include "sim/state/motion.h"
#include "sim/state/snapshot.h"

namespace sim {

/// The account of energy (docs/numerics.md, "Energy"): what flowed where since the start, and whether it adds
/// up.
///
/// The dampers' and frictions' work is exact in the discrete motion (see bond_kernel_body.h), so the residual
/// holds what the time step itself gets wrong, and nothing else.
class Ledger {
 public:
  explicit Ledger(const Network& network) : network_(&network) {}

  void addDissipated(double energy) { flows_.dissipated += energy; }
  void addReleased(double energy) { flows_.released += energy; }
  void addOutsideWork(double energy) { flows_.outsideWork += energy; }

  /// Draws up the account at one moment: velocities at that moment; `present` holds the elastic and contact
  /// energy as they are, and what was dissipated and done from outside since the flows were last added to.
  LedgerRow draw(double time, double step, const NodeVectors& position, const NodeVectors& velocity,
                 const Energy& present, const Vec3& gravity) const;
  /// Takes a row as the start, against which residuals are counted. `kept`: the
  /// mechanical energy that the method keeps, erg.
  void begin(const LedgerRow& row, double kept);
  /// Looks for rises of energy that nothing explains: of the true one, which goes up and down with every
  /// swing, and of what the method keeps, which another step or stiffness changes. Only where both
  /// rise is energy gained. False when the energy of the row is past all bounds: a blow-up.
  bool watch(const LedgerRow& row, double kept);
  /// Forces have leapt: what the method keeps is another energy from here on.
  void forgetKept() { lowestKept_ = std::numeric_limits<double>::infinity(); }

  double maxRise() const;
  /// Energy of position that a change of gravity gives, erg: the work of whatever changed it.
  double gravityWork(const NodeVectors& position, const Vec3& before, const Vec3& after) const;

  /// Goes on with the account of another one of the same network.
  void takeOver(const Ledger& other);
  void save(ByteWriter& writer) const;
  bool load(ByteReader& reader);

 private:
  /// Sum over nodes of finite mass of m (x - x at the start), g cm.
  Vec3 massMoved(const NodeVectors& position) const;

  const Network* network_;
  Energy flows_;              ///< dissipated, released, outsideWork since the start
  double start_ = 0.0;        ///< mechanical energy at the start, erg
  double lowest_ = 0.0;       ///< of mechanical - outsideWork so far, erg
  double lowestKept_ = 0.0;   ///< likewise of what the method keeps
  double largestRise_ = 0.0;  ///< above the lowest before, erg
  double scale_ = 0.0;        ///< the most energy seen in motion, bonds and contacts, erg
  double startActive_ = 0.0;  ///< that of the start, erg
};

}  // namespace sim
