#pragma once

#include "sim/contact/contact_forces.h"

/// Friction at colliders (docs/numerics.md, Contact 6): a spring along the surface from where a node was
/// first held, as between surfaces (Contact 10).
namespace sim {

/// In place of friction by speed: with contact of surfaces.
bool holdsAtColliders(const ContactModel& model);

/// From where friction holds a node of a collider to where it is, in the plane of contact, cm.
Vec3 stretchOf(const ColliderHold& hold, const Collider& collider, const Vec3& here, const Vec3& normal);

/// erg: what a hold stores. Past what friction can hold, `most` (cm), it is counted as what the force did on
/// the way from where it was last looked at, by the mean of both ends.
double energyOf(const ColliderHold& hold, double stretch, double most, double stiffness);

/// Lets friction take hold of what touches colliders, let go of what has left them, and follow what slides.
/// Once a step, after the forces of the moment. Gives the energy that is lost by it, erg.
double followHolds(Contacts& contacts, const ContactMoment& moment, const ContactForces& forces);

}  // namespace sim
