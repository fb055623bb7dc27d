#pragma once

#include <QWidget>

#include "ui/session/session.h"

class QLabel;
class QScrollArea;

namespace ui {

class PropertyForm;
class TextField;

/// The properties of what is selected last, and of everything selected that is of its kind; of the scene
/// where nothing is. Problems of the preview stand at the fields they belong to.
class Properties : public QWidget {
  Q_OBJECT

 public:
  explicit Properties(Session& session, QWidget* parent = nullptr);

  PropertyForm* form() { return form_; }

 private:
  void showSelection();
  void showScene();
  void showHead();
  void showProblem();
  std::vector<Item> shownItems() const;
  void takeName(const QString& name);
  std::vector<QString> namesIn(const std::vector<Item>& items) const;

  Session& session_;
  QLabel* icon_;
  TextField* name_;
  QLabel* about_;
  QScrollArea* area_;
  PropertyForm* form_ = nullptr;
  std::vector<Item> items_;
  std::vector<QString> names_;  ///< of the items, as shown last
  std::string structure_;
};

}  // namespace ui
