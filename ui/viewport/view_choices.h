#pragma once

#include <QFrame>

class QFormLayout;

namespace ui {

class Viewport;
struct ViewSettings;

/// The menu of everything a viewport can show; stays open while things are tried.
class ViewChoices : public QFrame {
  Q_OBJECT

 public:
  explicit ViewChoices(Viewport& viewport);

 private:
  void addHeading(const QString& text);
  void addCheck(const QString& text, const QString& tip, bool ViewSettings::*what);
  void addColouring();
  void addIsolated();
  void addExplode();

  Viewport& viewport_;
  QFormLayout* form_ = nullptr;
};

}  // namespace ui
