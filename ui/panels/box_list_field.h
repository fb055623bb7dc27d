#pragma once

#include <QWidget>
#include <vector>

#include "modeling/scene/part.h"

class QVBoxLayout;

namespace ui {

class VectorField;

/// The boxes in which a part is held: two corners each, to be added and taken away.
class BoxListField : public QWidget {
  Q_OBJECT

 public:
  explicit BoxListField(QWidget* parent = nullptr);
  void show(const modeling::Part& part);

 signals:
  void edited(const std::vector<modeling::Box>& boxes, bool finished);

 private:
  struct Row {
    QWidget* widget;
    VectorField* least;
    VectorField* most;
  };
  void addRow();
  void add();

  std::vector<Row> rows_;
  std::vector<modeling::Box> boxes_;
  Eigen::AlignedBox3d extent_;  ///< of the part, its own coordinates
  QVBoxLayout* column_;
};

}  // namespace ui
