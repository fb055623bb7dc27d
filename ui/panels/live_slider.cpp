#include "ui/panels/live_slider.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "ui/theme/theme.h"

namespace ui {
namespace {

constexpr int kPlaces = 1000;
/// px, so that sliders one below the other begin in a line.
constexpr int kNameWidth = 74;

}  // namespace

LiveSlider::LiveSlider(const QString& name, const QString& unit, const Range& range, QWidget* parent)
    : QWidget(parent),
      range_(range),
      name_(new QLabel(name, this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      field_(new QDoubleSpinBox(this)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->addWidget(name_, 0, 0);
  grid->addWidget(slider_, 0, 1);
  grid->addWidget(field_, 0, 2);
  grid->setColumnStretch(1, 1);
  name_->setFixedWidth(kNameWidth);
  slider_->setRange(0, kPlaces);
  slider_->setPageStep(kPlaces / 20);
  slider_->setAccessibleName(name);
  field_->setAccessibleName(name);
  field_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  field_->setRange(range.least, range.most);
  field_->setDecimals(range.scale == Scale::logarithmic ? 3 : 2);
  field_->setSuffix(unit);
  field_->setFont(Theme::numberFont(-0.5));
  field_->setAlignment(Qt::AlignRight);
  field_->setFixedWidth(88);
  field_->setKeyboardTracking(false);
  name_->installEventFilter(this);
  name_->setToolTip(tr("Double-click: back to the usual value"));
  connect(slider_, &QSlider::valueChanged, this, [this](int place) { choose(valueOf(place)); });
  connect(slider_, &QSlider::sliderReleased, this, &LiveSlider::released);
  connect(field_, &QDoubleSpinBox::valueChanged, this, [this](double typed) {
    choose(typed);
    emit released();
  });
  display();
}

int LiveSlider::placeOf(double value) const {
  const double inside = std::clamp(value, range_.least, range_.most);
  const double share = range_.scale == Scale::linear
                           ? (inside - range_.least) / (range_.most - range_.least)
                           : std::log(inside / range_.least) / std::log(range_.most / range_.least);
  return static_cast<int>(std::lround(share * kPlaces));
}

double LiveSlider::valueOf(int place) const {
  const double share = static_cast<double>(place) / kPlaces;
  if (range_.scale == Scale::linear) return range_.least + share * (range_.most - range_.least);
  return range_.least * std::pow(range_.most / range_.least, share);
}

void LiveSlider::setValue(double value) {
  if (slider_->isSliderDown() || field_->hasFocus() || value == value_) return;
  value_ = value;
  display();
}

void LiveSlider::display() {
  const QSignalBlocker sliderBlocker(slider_);
  const QSignalBlocker fieldBlocker(field_);
  slider_->setValue(placeOf(value_));
  field_->setValue(value_);
}

void LiveSlider::choose(double value) {
  value_ = value;
  // Whoever drags finds the usual value again without looking at the number.
  if (slider_->isSliderDown() && std::abs(placeOf(value) - placeOf(usual_)) <= kPlaces / 100) value_ = usual_;
  display();
  emit changed(value_);
}

bool LiveSlider::eventFilter(QObject* watched, QEvent* event) {
  if (watched != name_ || event->type() != QEvent::MouseButtonDblClick)
    return QWidget::eventFilter(watched, event);
  choose(usual_);
  emit released();
  return true;
}

}  // namespace ui
