#pragma once

#include <QWidget>
#include <optional>

#include "ui/editors/profile_model.h"
#include "ui/kinds/part_presets.h"
#include "ui/session/session.h"

class QAction;
class QLabel;
class QPushButton;
class QStackedWidget;
class QToolBar;

namespace ui {

class NumberField;
class ProfileCanvas;

/// The panel in which the profiles of the selected solid of revolution are drawn. Each change is an edit of
/// the document, so that the solid follows while a point is dragged.
class ProfileEditor : public QWidget {
  Q_OBJECT

 public:
  explicit ProfileEditor(Session& session, QWidget* parent = nullptr);

  ProfileCanvas& canvas() { return *canvas_; }
  /// Puts a preset's profiles in place of the part's; its place and material stay.
  void usePreset(ProfilePreset preset);
  void offsetInside();

 private:
  QWidget* makeEmptyState();
  QToolBar* makeToolBar();
  QWidget* makeFields();
  void addModes(QToolBar& bar);
  void addPointActions(QToolBar& bar);
  void addEnds(QToolBar& bar);
  void addViewActions(QToolBar& bar);
  QAction* addAction(QToolBar& bar, const QString& icon, const QString& text, const QString& tip);

  /// The part of the scene that is drawn, if the selection says one.
  std::optional<std::size_t> findPart();
  void follow();
  void showSelected();
  void showMessage();
  void write(const QString& name, const modeling::RevolutionShape& shape, const QString& gesture);
  void placeSelected(std::size_t axis, double value, bool finished);
  void closeEnd(bool upper, bool closed);
  /// Which end of the profiles is the upper.
  ProfileEnd endOf(bool upper) const;
  /// A solid of revolution that could be selected.
  std::optional<std::size_t> anyPart() const;

  Session& session_;
  std::string partName_;  ///< of what is drawn; "": nothing
  QStackedWidget* pages_ = nullptr;
  ProfileCanvas* canvas_ = nullptr;
  QPushButton* selectPart_ = nullptr;
  QAction* selectMode_ = nullptr;
  QAction* insertMode_ = nullptr;
  QAction* snap_ = nullptr;
  QAction* lowerClosed_ = nullptr;
  QAction* upperClosed_ = nullptr;
  std::vector<QAction*> pointActions_;
  NumberField* radius_ = nullptr;
  NumberField* height_ = nullptr;
  NumberField* thickness_ = nullptr;
  QLabel* message_ = nullptr;
  QString refusal_;
  bool thicknessTyped_ = false;
};

}  // namespace ui
