#pragma once

#include "sim/contact/contact_forces.h"
#include "sim/contact/surface_rows.h"

/// The forces of surfaces on each other (docs/numerics.md, "Contact and friction").
namespace sim {

/// Adds to the forces of this moment. In the order of the contacts, for any number of threads.
void addSurfaceForces(const ContactModel& model, const SurfaceRows& rows, const ContactMoment& moment,
                      ContactForces& forces);

/// erg
double surfaceEnergy(const ContactModel& model, const SurfaceRows& rows, const ContactMoment& moment);

/// What touches, or may before the step is chosen again.
Stiffest stiffestSurfaces(const ContactModel& model, const SurfaceRows& rows, const ContactMoment& moment);

}  // namespace sim
