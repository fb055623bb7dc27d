#include "ui/viewport/heartbeat.h"

#include <algorithm>

namespace ui {
namespace {

constexpr int kBeatMilliseconds = 5;
constexpr qint64 kSpanMilliseconds = 5000;

}  // namespace

Heartbeat::Heartbeat(QObject* parent) : QObject(parent) {
  timer_.setInterval(kBeatMilliseconds);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &Heartbeat::beat);
}

void Heartbeat::listen(bool on) {
  if (on == timer_.isActive()) return;
  present_ = before_ = 0.0;
  last_.start();
  span_.start();
  on ? timer_.start() : timer_.stop();
}

double Heartbeat::longestWait() const {
  return std::max(present_, before_);
}

void Heartbeat::beat() {
  const double wait = static_cast<double>(last_.nsecsElapsed()) * 1e-6;
  last_.start();
  if (span_.elapsed() > kSpanMilliseconds) {
    span_.start();
    before_ = std::exchange(present_, 0.0);
  }
  present_ = std::max(present_, wait);
}

}  // namespace ui
