#pragma once

#include <QObject>
#include <cstdint>
#include <vector>

class QAction;
class QActionGroup;
class QMenu;

namespace ui {

class TransformTool;
class Viewport;
enum class TransformMode : std::uint8_t;
struct ViewSettings;

/// What menus, bars and keys do to a viewport: views, what is drawn, and the tools that every scene needs.
class ViewActions : public QObject {
  Q_OBJECT

 public:
  explicit ViewActions(Viewport& viewport);

  /// The whole of a View menu.
  void addTo(QMenu& menu) const;
  const std::vector<QAction*>& tools() const { return tools_; }
  const std::vector<QAction*>& shows() const { return shows_; }
  QAction* snap() const { return snap_; }

 private:
  QAction* make(const QString& text, const QString& icon, const QString& key, const QString& tip);
  void makeViews();
  void makeShows();
  void makeTools();
  void makeTool(TransformMode mode, const QString& text, const QString& icon, const QString& key,
                const QString& tip);
  void makeShow(bool ViewSettings::*what, const QString& text, const QString& icon, const QString& key,
                const QString& tip);
  void showTool();
  void showSettings();

  Viewport& viewport_;
  std::vector<QAction*> views_;
  std::vector<QAction*> shows_;
  std::vector<QAction*> tools_;
  std::vector<bool ViewSettings::*> shown_;  ///< one a show
  QAction* orthographic_ = nullptr;
  QAction* statistics_ = nullptr;
  QAction* snap_ = nullptr;
};

}  // namespace ui
