#pragma once

#include <memory>
#include <thread>

#include "ui/viewport/draw_data.h"

namespace ui {

/// The thread that makes draw data of what is shown. Of requests that come faster than they can be prepared
/// the newest counts. Every function may be called from any thread and returns at once.
class DrawPreparer {
 public:
  DrawPreparer();
  ~DrawPreparer();
  DrawPreparer(const DrawPreparer&) = delete;
  DrawPreparer& operator=(const DrawPreparer&) = delete;

  void request(const Shown& shown, const ViewSettings& settings);
  /// The newest that is ready; never null.
  std::shared_ptr<const DrawData> newest() const;
  /// Something is being prepared or waits to be.
  bool isBusy() const;

 private:
  class Thread;
  std::shared_ptr<Thread> thread_;  ///< shared with the thread itself, which may outlive this
  std::jthread runner_;
};

}  // namespace ui
