#pragma once

#include <memory>
#include <optional>
#include <unordered_map>

#include "ui/session/background_worker.h"
#include "ui/session/footage.h"

namespace ui {

/// When and why bonds broke, read from a take in a thread of its own (BackgroundWorker), because it may stand
/// on the disk.
class BreakHistory {
 public:
  BreakHistory();

  /// The break of a bond. Nothing where it is not known (yet): then the take is read again, unless it is
  /// being read.
  std::optional<sim::BreakEvent> of(const std::shared_ptr<Footage>& footage, sim::BondIndex bond);
  bool isReading() const { return worker_.isBusy(); }

 private:
  struct Request {
    std::shared_ptr<Footage> footage;
    std::size_t frames = 0;  ///< there were so many when it was asked for
  };
  struct History {
    Request of;
    std::unordered_map<sim::BondIndex, sim::BreakEvent> events;
  };
  BackgroundWorker<Request, History> worker_;
};

}  // namespace ui
