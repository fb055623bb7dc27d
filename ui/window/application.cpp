#include "ui/window/application.h"

#include <QTimer>
#include <iostream>

#include "ui/files/autosave.h"
#include "ui/session/background_thread.h"

namespace ui {
namespace {

constexpr qint64 kSameAgain = 60'000;  ///< ms: the same is not told before
constexpr int kOther = 1000;           ///< ms: nor anything else

}  // namespace

bool Application::notify(QObject* receiver, QEvent* event) {
  try {
    return QApplication::notify(receiver, event);
  } catch (...) {
    // Where even this fails there is no memory left for words.
    static_cast<void>(guarded([&]() -> sim::Status {
      keep(problemOfException());
      return sim::Done{};
    }));
  }
  return false;
}

int Application::caughtCount() const {
  const std::lock_guard lock(mutex_);
  return caught_;
}

void Application::keep(const sim::Problem& problem) {
  const std::lock_guard lock(mutex_);
  ++caught_;
  if (telling_) return;
  const qint64 since = sinceTold_.isValid() ? sinceTold_.elapsed() : kSameAgain;
  if (problem.what == toldLast_ && since < kSameAgain) return;
  pending_ = problem;
  telling_ = true;
  const int delay = since < kOther ? kOther : 0;
  QMetaObject::invokeMethod(
      this, [this, delay] { QTimer::singleShot(delay, this, &Application::tell); }, Qt::QueuedConnection);
}

void Application::tell() {
  sim::Problem problem;
  {
    const std::lock_guard lock(mutex_);
    problem = pending_;
    toldLast_ = problem.what;
    sinceTold_.start();
  }
  std::cerr << "smithereens: caught: " << problem.what << '\n';
  static_cast<void>(guarded([&]() -> sim::Status {
    emit caught(problem);
    return sim::Done{};
  }));
  const std::lock_guard lock(mutex_);
  telling_ = false;
}

void spreadNet(Application& application, Session& session, Autosave& autosave) {
  QObject::connect(
      &application, &Application::caught, &session, [&session, &autosave](const sim::Problem& problem) {
        // Told even where the scene cannot be put aside.
        const sim::Status kept = guarded([&]() -> sim::Status {
          autosave.write();
          return sim::Done{};
        });
        session.report(
            {"",
             "the program made a mistake, and what was just asked for may not be done (" + problem.what + ")",
             kept ? "what is not saved was put aside; save it, and go on" : "save the scene"});
      });
}

}  // namespace ui
