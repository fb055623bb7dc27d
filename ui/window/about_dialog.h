#pragma once

#include <QDialog>

namespace ui {

/// Version, licence, the paper, and the libraries with theirs.
class AboutDialog : public QDialog {
  Q_OBJECT

 public:
  explicit AboutDialog(QWidget* parent = nullptr);
};

}  // namespace ui
