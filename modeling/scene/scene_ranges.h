#pragma once

#include <optional>

#include "modeling/scene/scene.h"
#include "modeling/text/json_fields.h"

/// Every number of a scene has bounds, which stand in its list of fields (NumberRange). A reader keeps to
/// them value by value; these functions do for scenes that no reader made.
namespace modeling {

/// Of a step that is given by its tolerance.
inline constexpr Rule kToleranceRule{
    "tolerance", "Error of strain a shortest swing.", true, {1e-12, 1.0}, false};

/// What a key of a track with that target may be, each number of it.
NumberRange keyRange(const TargetName& target);
/// When a key may be, s.
NumberRange keyTimeRange();

/// The first number that is out of its bounds, by a path such as "parts[0].size[1]"; nothing where all are
/// within.
std::optional<sim::Problem> numberOutOfRange(const Scene& scene);

/// Brings each number that is out of its bounds to the nearest one within, and what is no number at all to
/// the one nearest to 0. So whatever is done to a scene by hand, its file can be read again.
void keepNumbersInRange(Scene& scene);

}  // namespace modeling
