#include "ui/panels/interval_field.h"

#include <QHBoxLayout>
#include <QLabel>

namespace ui {
namespace {

/// How long, s, an interval is at first of which one end was given.
constexpr double kUsualLength = 1.0;

}  // namespace

IntervalField::IntervalField(const NumberFormat& format, QWidget* parent) : QWidget(parent) {
  NumberFormat start = format;
  start.autoText = tr("the start");
  NumberFormat end = format;
  end.autoText = tr("the end");
  from_ = new NumberField(start, this);
  from_->setAccessibleName(tr("from"));
  until_ = new NumberField(end, this);
  until_->setAccessibleName(tr("until"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  row->addWidget(from_, 1);
  row->addWidget(new QLabel(tr("to"), this));
  row->addWidget(until_, 1);
  connect(from_, &NumberField::edited, this,
          [this](std::optional<double> value, bool finished) { take(0, value, finished); });
  connect(until_, &NumberField::edited, this,
          [this](std::optional<double> value, bool finished) { take(1, value, finished); });
}

void IntervalField::setValue(const Interval& value) {
  value_ = value;
  from_->setValue(value ? std::optional((*value)[0]) : std::nullopt);
  until_->setValue(value ? std::optional((*value)[1]) : std::nullopt);
}

void IntervalField::setMixed(bool mixed) {
  from_->setMixed(mixed);
  until_->setMixed(mixed);
}

void IntervalField::take(std::size_t end, std::optional<double> value, bool finished) {
  if (!value) {
    value_.reset();
  } else if (value_) {
    (*value_)[end] = *value;
  } else if (end == 0) {
    value_ = {*value, *value + kUsualLength};
  } else {
    // What has no start named is there from the first moment on.
    value_ = {std::min(0.0, *value - kUsualLength), *value};
  }
  setValue(value_);
  emit edited(value_, finished);
}

}  // namespace ui
