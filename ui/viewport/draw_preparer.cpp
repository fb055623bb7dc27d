#include "ui/viewport/draw_preparer.h"

#include "ui/viewport/draw_maker.h"

namespace ui {

DrawPreparer::DrawPreparer()
    : worker_([maker = std::make_shared<DrawMaker>()](const Request& request, auto& job) {
        const sim::Status made = guarded([&]() -> sim::Status {
          job.value = maker->make(request.shown, request.settings, [&job] { return job.cancelled(); });
          return sim::Done{};
        });
        // What it keeps from one moment to the next may be half made.
        if (!made) *maker = DrawMaker();
        return made;
      }) {}

std::shared_ptr<const DrawData> DrawPreparer::newest() const {
  const auto answer = worker_.newest();
  return {answer, &answer->value};
}

}  // namespace ui
