#pragma once

#include <QWidget>
#include <vector>

#include "modeling/scene/tracks.h"

class QGridLayout;
class QToolButton;

namespace ui {

class NumberField;

/// The keys of a track as rows of time and value.
class KeyTable : public QWidget {
  Q_OBJECT

 public:
  explicit KeyTable(QWidget* parent = nullptr);
  void show(const modeling::SceneTrack& track);

 signals:
  /// Times ascend.
  void edited(const std::vector<modeling::SceneTrackKey>& keys, bool finished);

 private:
  struct Row {
    NumberField* time;
    std::vector<NumberField*> values;
    QToolButton* remove;
  };
  void addRow();
  void clearRows();
  void takeTime(std::size_t row, double time, bool finished);
  void takeValue(std::size_t row, std::size_t component, double value, bool finished);
  void addKey();

  modeling::SceneTrack track_;  ///< as shown and changed
  std::vector<Row> rows_;
  QGridLayout* grid_;
};

}  // namespace ui
