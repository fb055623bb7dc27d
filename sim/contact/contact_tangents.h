#pragma once

#include <vector>

#include "sim/contact/contact_forces.h"
#include "sim/state/tangent.h"

namespace sim {

/// Adds what pushes now, for implicit methods; `forces` are those of this moment.
void addContactTangents(const Contacts& contacts, const ContactMoment& moment, const ContactForces& forces,
                        std::vector<Tangent>& tangents);

}  // namespace sim
