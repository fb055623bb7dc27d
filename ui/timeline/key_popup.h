#pragma once

#include <QFrame>
#include <vector>

#include "ui/document/pending_edit.h"
#include "ui/timeline/track_following.h"

class QDoubleSpinBox;

namespace ui {

class Document;

/// Fields beside a key, into which its time and value are typed. Goes away when one clicks elsewhere, by
/// Enter, by Esc, which leaves the key as it was, and when the key goes.
class KeyPopup : public QFrame, public PendingEdit {
  Q_OBJECT

 public:
  KeyPopup(Document& document, const KeyPlace& place, QWidget* parent);

  void open(const QPoint& globalPosition);
  void rehearse() override { apply(); }

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QDoubleSpinBox* addField(const QString& name, double value, const QString& unit, int decimals);
  void apply();
  void followKey();

  Document& document_;
  Tracks known_;                   ///< those that the place is in
  std::optional<KeyPlace> place_;  ///< nothing once the key is gone
  QDoubleSpinBox* time_ = nullptr;
  std::vector<QDoubleSpinBox*> values_;
};

}  // namespace ui
