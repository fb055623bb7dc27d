#pragma once

#include <QWidget>

namespace ui {

class AddActions;
class Session;

/// Stands over the viewport while the scene has no parts: what to do first, as big buttons.
class EmptyScene : public QWidget {
  Q_OBJECT

 public:
  /// `over` is what it stands in the middle of.
  EmptyScene(Session& session, AddActions& actions, QWidget* over);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void showScene();
  void place();

  Session& session_;
};

}  // namespace ui
