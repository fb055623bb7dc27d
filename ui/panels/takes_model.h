#pragma once

#include <QAbstractListModel>
#include <QStyledItemDelegate>

namespace ui {

class Session;
struct Take;

/// The session's takes for a list view.
class TakesModel : public QAbstractListModel {
  Q_OBJECT

 public:
  explicit TakesModel(Session& session, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 private:
  void follow();
  /// The lengths of takes that are being made.
  void followRun();
  QString tipOf(const Take& take) const;

  Session& session_;
  int count_ = 0;
};

/// A picture, the name, and below what else is known.
class TakeDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  TakeDelegate(Session& session, QObject* parent);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const override;

 private:
  void paintPicture(QPainter& painter, const QRect& frame, const Take& take) const;

  Session& session_;
};

}  // namespace ui
