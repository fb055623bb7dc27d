#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "ui/session/session.h"
#include "ui/viewport/pick.h"

/// What there is to say about something that was picked, at the moment shown.
namespace ui {

struct Fact {
  QString name;
  QString value;
};

struct Inspection {
  QString title;  ///< empty: there is nothing
  std::vector<Fact> facts;
  std::optional<sim::FragmentId> fragment;  ///< it is, or belongs to
  std::optional<double> strainOfThreshold;  ///< of a bond that holds: at 1 it breaks
};

/// `event`: how a broken bond broke, where it is known.
Inspection inspect(const Pick& pick, const Shown& shown, const std::optional<sim::BreakEvent>& event);
bool isBroken(const Pick& pick, const Shown& shown);

}  // namespace ui
