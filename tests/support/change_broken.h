#pragma once

#include <utility>

#include "sim/state/snapshot.h"

namespace tests {

/// Gives a moment another record of what is broken: the present one as `change` leaves it.
template <class Change>
void changeBroken(sim::Snapshot& moment, const Change& change) {
  sim::Broken broken = *moment.broken;
  change(broken);
  moment.broken = sim::sealed(std::move(broken));
}

}  // namespace tests
