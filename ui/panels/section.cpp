#include "ui/panels/section.h"

#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/theme/theme.h"

namespace ui {
namespace {

QString keyOf(const QString& title) {
  return QStringLiteral("sections/") + title;
}

}  // namespace

Section::Section(const QString& title, bool open, QWidget* parent)
    : QWidget(parent), key_(keyOf(title)), open_(QSettings().value(key_, open).toBool()) {
  head_ = new QToolButton(this);
  head_->setText(title);
  head_->setObjectName(QStringLiteral("section-head"));
  head_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  head_->setIconSize(QSize(10, 10));
  head_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  QFont font = head_->font();
  font.setWeight(QFont::DemiBold);
  head_->setFont(font);
  head_->setStyleSheet(
      QStringLiteral("QToolButton { background: transparent; border: 1px solid transparent; padding: 3px 0; }"
                     "QToolButton:focus { border-color: palette(highlight); }"));
  body_ = new QWidget(this);
  rows_ = new QVBoxLayout(body_);
  rows_->setContentsMargins(0, 0, 0, 6);
  rows_->setSpacing(4);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(head_);
  column->addWidget(body_);
  connect(head_, &QToolButton::clicked, this, [this] { setOpen(!open_); });
  showArrow();
}

void Section::add(QWidget* content) {
  rows_->addWidget(content);
}

bool Section::isOpen() const {
  return open_;
}

void Section::setOpen(bool open) {
  open_ = open;
  QSettings().setValue(key_, open);
  showArrow();
}

void Section::showArrow() {
  head_->setIcon(Theme::icon(isOpen() ? QStringLiteral("chevron-down") : QStringLiteral("chevron-right")));
  body_->setVisible(isOpen());
}

}  // namespace ui
