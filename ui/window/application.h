#pragma once

#include <QApplication>
#include <QElapsedTimer>
#include <mutex>

#include "sim/base/result.h"

namespace ui {

class Autosave;
class Session;

/// The application, with a net beneath all event handlers, timers and queued calls: what one of them throws
/// ends that event, and nothing else. It is told from the event loop afterwards, when all that called the
/// handler has returned.
///
/// What throws again and again, such as a picture that is painted sixty times a second, is told once a
/// minute.
class Application : public QApplication {
  Q_OBJECT

 public:
  Application(int& argumentCount, char** arguments) : QApplication(argumentCount, arguments) {}

  bool notify(QObject* receiver, QEvent* event) override;
  /// How often something was caught since the start, told or not.
  int caughtCount() const;

 signals:
  /// Something threw. What a slot of this throws in turn is dropped.
  void caught(const sim::Problem& problem);

 private:
  void keep(const sim::Problem& problem);
  void tell();

  mutable std::mutex mutex_;  ///< of all below: threads of Qt have event loops, too
  int caught_ = 0;
  bool telling_ = false;  ///< tell() is under way, or will be called
  sim::Problem pending_;  ///< to be told
  std::string toldLast_;
  QElapsedTimer sinceTold_;  ///< not valid: nothing was told yet
};

/// Where something is caught, the scene is put aside at once, and the window says so.
void spreadNet(Application& application, Session& session, Autosave& autosave);

}  // namespace ui
