#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/bench/contact_measure.h"

namespace app {

/// One of the values that a case measures: a row of the table.
struct ContactQuantity {
  std::string name;
  std::string unit;                ///< "": it has none
  std::optional<double> expected;  ///< by a closed form or by what is sought; nothing: nobody knows
  std::string goal = "none";       ///< in words
  bool overNodes = false;          ///< what is told is its ratio to the same by nodes
};

/// One way in which bodies touch, and what is measured of it.
struct ContactCase {
  std::string what;
  std::string cells;                        ///< their edges in cm, "upper on lower" where they differ
  std::vector<ContactQuantity> quantities;  ///< of an outcome's values, in their order
  std::function<sim::Result<ContactOutcome>(sim::ContactKind kind)> run;
  bool byNodes = true;  ///< whether it is run by nodes, too
  bool slow = false;    ///< takes more than some 5 s of the processor
};

/// All cases. A Problem where what comes with the program, scenes and materials, cannot be read.
sim::Result<std::vector<ContactCase>> contactCases();

}  // namespace app
