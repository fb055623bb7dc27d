#pragma once

#include "sim/contact/contact_model.h"
#include "sim/contact/surface_rows.h"

namespace sim {

/// When surfaces are followed.
struct SurfaceMoment {
  const NodeVectors& positions;
  double odometer = 0.0;  ///< cm, as in RowAge
  double travel = 0.0;    ///< cm: no node went further in the last step
  bool starts = false;    ///< nodes that are inside another surface begin there, as deep as they are
};

/// Brings the contacts to where the nodes are now: which places meet, how far gaps have let rho grow, and
/// where friction lets go. Gives the energy that is lost by it, erg.
double followSurfaces(const ContactModel& model, const Outside& outside, const SurfaceMoment& moment,
                      SurfaceRows& rows);

/// erg, with unscaled stiffness
double contactEnergy(const SurfaceContact& contact, const NodeVectors& positions);

}  // namespace sim
