#pragma once

#include <QByteArray>
#include <QObject>
#include <vector>

#include "ui/window/window_actions.h"

class QDockWidget;
class QMainWindow;
class QWidget;

namespace ui {

class Session;
class Viewport;

/// The panels around the viewport, and how they are laid out, from one start of the program to the next.
class Docks : public QObject {
  Q_OBJECT

 public:
  /// Makes them. `window` has its central widget already.
  Docks(QMainWindow& window, Session& session, Viewport& viewport, const WindowActions& actions);

  const std::vector<QDockWidget*>& all() const { return docks_; }
  void hideAll();

  /// The layout is now as it comes out of the box: useFirstLayout() leads back here.
  void markFirstLayout();
  void useFirstLayout();
  void rememberLayout() const;
  /// As remembered; false where nothing is, or it is another version's.
  bool recallLayout();

 private:
  void makeSides(Session& session, Viewport& viewport, const WindowActions& actions);
  void makeBottom(Session& session, const WindowActions& actions);
  void makeProfile(Session& session, const WindowActions& actions);
  QDockWidget* addDock(const QString& name, const QString& title, QWidget* content, Qt::DockWidgetArea area);
  void toggleProfile();

  QMainWindow& window_;
  std::vector<QDockWidget*> docks_;
  QDockWidget* outliner_ = nullptr;
  QDockWidget* properties_ = nullptr;
  QDockWidget* profile_ = nullptr;
  int widthBeforeProfile_ = 0;  ///< of the docks at the left, logical pixels; 0: not known
  QByteArray firstLayout_;      ///< as it comes out of the box
};

}  // namespace ui
