#pragma once

#include "sim/contact/contact_model.h"
#include "sim/contact/surface_rows.h"

namespace sim {

/// Brings the contacts to where the nodes are now: which places meet, how far gaps have let rho grow, and
/// where friction lets go. `odometer` as in RowAge, cm. Gives the energy that is lost by it, erg.
double followSurfaces(const ContactModel& model, const Outside& outside, const NodeVectors& positions,
                      double odometer, SurfaceRows& rows);

/// erg, with unscaled stiffness
double contactEnergy(const SurfaceContact& contact, const NodeVectors& positions);

}  // namespace sim
