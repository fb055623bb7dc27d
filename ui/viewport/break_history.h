#pragma once

#include <memory>
#include <optional>

#include "ui/session/footage.h"

namespace ui {

/// When and why bonds broke, read from a take by a thread of its own, because it may stand on the disk.
class BreakHistory {
 public:
  /// The break of a bond. Nothing where it is not known (yet): then the take is read again, unless it is
  /// being read.
  std::optional<sim::BreakEvent> of(const std::shared_ptr<Footage>& footage, sim::BondIndex bond);
  bool isReading() const;

 private:
  struct Reading;
  std::shared_ptr<Reading> reading_;
};

}  // namespace ui
