#pragma once

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace ui {

/// A name, a slider and a field of the same number.
class LiveSlider : public QWidget {
  Q_OBJECT

 public:
  enum class Scale { linear, logarithmic };
  struct Range {
    double least = 0.0;
    double most = 1.0;
    Scale scale = Scale::linear;
  };

  LiveSlider(const QString& name, const QString& unit, const Range& range, QWidget* parent = nullptr);

  double value() const { return value_; }
  /// Says nothing; not heeded while a person holds it.
  void setValue(double value);
  /// A double click on the name brings it back to this.
  void setUsual(double value) { usual_ = value; }

 signals:
  /// By a person.
  void changed(double value);
  /// Let go of.
  void released();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  int placeOf(double value) const;
  double valueOf(int place) const;
  void display();
  void choose(double value);

  Range range_;
  double value_ = 0.0;
  double usual_ = 1.0;
  QLabel* name_;
  QSlider* slider_;
  QDoubleSpinBox* field_;
};

}  // namespace ui
