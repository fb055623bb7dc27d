#pragma once

#include <QObject>
#include <QString>

namespace ui {

/// Which stretch of time lies across the timeline, and where in it each moment is. Shared by all that is
/// drawn along it. Times in s, places in logical pixels from the left of the stretch.
class TimeAxis : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  double from() const { return from_; }
  double to() const { return from_ + width_ * secondsPerPixel_; }
  double width() const { return width_; }
  double secondsPerPixel() const { return secondsPerPixel_; }
  double xOf(double time) const { return (time - from_) / secondsPerPixel_; }
  double timeAt(double x) const { return from_ + x * secondsPerPixel_; }

  void setWidth(double pixels);
  /// s: all there is to see ends here. Whoever sees all of it goes on seeing all.
  void setEnd(double end);
  double end() const { return end_; }
  /// Nearer by a factor below 1; what is at x stays there.
  void zoom(double factor, double x);
  void pan(double pixels);
  void showAll();
  void show(double from, double to);
  bool showsAll() const { return showsAll_; }

  /// s, of 1, 2 or 5 times a power of ten: between labels that are at least so far apart.
  double labelStep(double pixels) const;

 signals:
  void changed();

 private:
  void place(double from, double secondsPerPixel);
  double widestScale() const;

  double from_ = 0.0;
  double width_ = 1.0;
  double end_ = 1.0;
  double secondsPerPixel_ = 1.0;
  bool showsAll_ = true;
};

/// With as many digits as the step between labels needs.
QString timeLabel(double time, double step);

}  // namespace ui
