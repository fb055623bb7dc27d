#pragma once

#include <QAbstractButton>
#include <QImage>
#include <QWidget>
#include <filesystem>

namespace ui {

/// A scene to open: its picture, what it is called and what happens in it.
class Card : public QAbstractButton {
  Q_OBJECT

 public:
  Card(const QString& title, const QString& words, const QImage& picture, QWidget* parent = nullptr);
  /// Stands in the picture's place where there is none.
  void setIconName(const QString& name) { iconName_ = name; }

  /// The picture is 16 : 10, with two lines below it.
  static int heightFor(int width);

 protected:
  void paintEvent(QPaintEvent* event) override;
  QSize sizeHint() const override;

 private:
  QString words_;
  QImage picture_;
  QString iconName_ = QStringLiteral("cup");
};

/// Cards in as many columns as there is room for, all of one width.
class CardGrid : public QWidget {
  Q_OBJECT

 public:
  explicit CardGrid(QWidget* parent = nullptr);
  void add(Card* card);
  void clear();
  bool isEmpty() const { return cards_.empty(); }

  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  int columnsFor(int width) const;
  int cardWidth(int width) const;
  void arrange();

  std::vector<Card*> cards_;
};

}  // namespace ui
