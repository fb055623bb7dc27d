#pragma once

#include <memory>
#include <optional>

#include "ui/session/background_worker.h"
#include "ui/viewport/draw_data.h"

namespace ui {

/// Makes draw data of what is shown in a thread of its own (BackgroundWorker).
class DrawPreparer {
 public:
  DrawPreparer();

  void request(const Shown& shown, const ViewSettings& settings) { worker_.request({shown, settings}); }
  /// The newest that is ready; never null. Nothing is drawn where it could not be made.
  std::shared_ptr<const DrawData> newest() const;
  /// Why the newest could not be made.
  std::optional<sim::Problem> problem() const { return worker_.newest()->problem; }
  /// Something is being prepared or waits to be.
  bool isBusy() const { return worker_.isBusy(); }

 private:
  struct Request {
    Shown shown;
    ViewSettings settings;
  };
  BackgroundWorker<Request, DrawData> worker_;
};

}  // namespace ui
