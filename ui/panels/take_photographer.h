#pragma once

#include <QObject>

namespace ui {

class Session;
class Viewport;

/// Takes a picture of each run for the list of takes: as it looks a third of the way from the first break to
/// the end, or at the end where nothing breaks.
class TakePhotographer : public QObject {
  Q_OBJECT

 public:
  TakePhotographer(Session& session, Viewport& viewport, QObject* parent = nullptr);

 private:
  void look();
  void shoot();

  Session& session_;
  Viewport& viewport_;
  std::uint64_t shotRun_ = 0;
};

}  // namespace ui
