#pragma once

#include <string>

#include "modeling/exchange/lammps_text.h"
#include "sim/collider/collider.h"

namespace modeling {

/// Whether LAMMPS can be told in formulas what the collider does.
bool hasLammpsFormulas(const sim::Collider& collider);

/// Adds what the collider does to the nodes of the group "moving", if there are formulas for it; `id` differs
/// from that of every other collider. `step`: s.
void addLammpsCollider(const sim::Collider& collider, const std::string& id, double step, LammpsText& script);

}  // namespace modeling
