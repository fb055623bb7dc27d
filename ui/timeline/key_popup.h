#pragma once

#include <QFrame>
#include <vector>

#include "ui/timeline/track_edits.h"

class QDoubleSpinBox;

namespace ui {

class Document;

/// Fields beside a key, into which its time and value are typed. Goes away when one clicks elsewhere, by
/// Enter and by Esc, which leaves the key as it was.
class KeyPopup : public QFrame {
  Q_OBJECT

 public:
  KeyPopup(Document& document, std::size_t track, std::size_t key, QWidget* parent);

  void open(const QPoint& globalPosition);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QDoubleSpinBox* addField(const QString& name, double value, const QString& unit, int decimals);
  void apply();

  Document& document_;
  std::size_t track_;
  std::size_t key_;
  QDoubleSpinBox* time_ = nullptr;
  std::vector<QDoubleSpinBox*> values_;
};

}  // namespace ui
