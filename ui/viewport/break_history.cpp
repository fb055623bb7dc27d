#include "ui/viewport/break_history.h"

#include <atomic>
#include <thread>
#include <unordered_map>

namespace ui {

/// Shared with the thread, which may outlive the window by the time of a look at the disk. The map is written
/// before `done` and only read after it.
struct BreakHistory::Reading {
  std::shared_ptr<Footage> footage;
  std::size_t frames = 0;
  std::unordered_map<sim::BondIndex, sim::BreakEvent> events;
  std::atomic<bool> done = false;
};

bool BreakHistory::isReading() const {
  return reading_ && !reading_->done;
}

std::optional<sim::BreakEvent> BreakHistory::of(const std::shared_ptr<Footage>& footage,
                                                sim::BondIndex bond) {
  if (!footage) return std::nullopt;
  const bool same = reading_ && reading_->footage == footage;
  if (same && reading_->done) {
    if (const auto found = reading_->events.find(bond); found != reading_->events.end()) return found->second;
    if (reading_->frames == footage->frameCount()) return std::nullopt;
  }
  if (same && !reading_->done) return std::nullopt;
  reading_ = std::make_shared<Reading>();
  reading_->footage = footage;
  reading_->frames = footage->frameCount();
  std::thread([reading = reading_] {
    if (const auto events = reading->footage->events()) {
      for (const sim::BreakEvent& event : *events) reading->events.emplace(event.bond, event);
    }
    reading->done = true;
  }).detach();
  return std::nullopt;
}

}  // namespace ui
