#pragma once

#include <QWidget>

#include "ui/panels/inspection.h"

class QGridLayout;
class QLabel;
class QProgressBar;
class QStackedWidget;
class QToolButton;

namespace ui {

class BreakHistory;
class Viewport;

/// What was clicked last in the viewport, at the moment shown.
class InspectorPanel : public QWidget {
  Q_OBJECT

 public:
  InspectorPanel(Session& session, Viewport& viewport, QWidget* parent = nullptr);
  ~InspectorPanel() override;

  void lookAt(const Pick& pick);
  const Inspection& inspection() const { return found_; }

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void look();
  void display();
  void makePage();
  std::optional<sim::BreakEvent> breakOf(const Pick& pick);

  Session& session_;
  std::unique_ptr<BreakHistory> breaks_;
  Pick pick_;
  Inspection found_;
  QStackedWidget* stack_ = nullptr;
  QLabel* title_ = nullptr;
  QProgressBar* strain_ = nullptr;
  QToolButton* fragment_ = nullptr;
  QGridLayout* facts_ = nullptr;
  std::vector<QLabel*> labels_;
};

}  // namespace ui
