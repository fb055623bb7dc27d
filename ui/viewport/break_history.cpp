#include "ui/viewport/break_history.h"

namespace ui {

BreakHistory::BreakHistory()
    : worker_([](const Request& request, auto& job) -> sim::Status {
        job.value.of = request;
        const auto events = request.footage->events();
        if (!events) return events.problem();
        for (const sim::BreakEvent& event : *events) job.value.events.emplace(event.bond, event);
        return sim::Done{};
      }) {}

std::optional<sim::BreakEvent> BreakHistory::of(const std::shared_ptr<Footage>& footage,
                                                sim::BondIndex bond) {
  if (!footage || worker_.isBusy()) return std::nullopt;
  const auto answer = worker_.newest();
  if (answer->value.of.footage == footage) {
    const auto found = answer->value.events.find(bond);
    if (found != answer->value.events.end()) return found->second;
    if (answer->value.of.frames == footage->frameCount()) return std::nullopt;
  }
  worker_.request({footage, footage->frameCount()});
  return std::nullopt;
}

}  // namespace ui
