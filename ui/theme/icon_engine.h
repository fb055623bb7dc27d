#pragma once

#include <QIconEngine>

namespace ui {

/// Draws an icon of resources/icons in the colours of the present theme, at the size and resolution asked
/// for.
class IconEngine : public QIconEngine {
 public:
  explicit IconEngine(QString name) : name_(std::move(name)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override;
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override;
  QIconEngine* clone() const override { return new IconEngine(name_); }

 private:
  QString name_;
};

}  // namespace ui
