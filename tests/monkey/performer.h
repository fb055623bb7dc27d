#pragma once

#include <filesystem>

#include "tests/monkey/action.h"
#include "ui/window/main_window.h"

namespace monkey {

/// Does what an action says to the window. Pointer and keys come as they do from the system, by way of
/// whatever window is on top; places are pixels of the screen. What happens without a hand, such as an undo
/// while the mouse holds something, is done to the session.
class Performer {
 public:
  /// `folder`: where scenes are opened from and saved to.
  Performer(ui::MainWindow& window, std::filesystem::path folder);

  /// What means nothing at present, such as the third part of two, is left out.
  void perform(const Action& action);
  /// Nothing runs, no take is kept, a small scene is open that nobody edited, and the window is as it was at
  /// first.
  void calm();

  /// The window that gets the pointer: a popup, else a dialog that keeps all others waiting, else what is
  /// there.
  static QWidget* topWindow(const QPoint& at);
  /// The names of the scenes in the folder.
  static QStringList sceneNames();

 private:
  using Words = QStringList;
  bool point(const QString& verb, const Words& words);
  bool press(const QString& verb, const Words& words);
  bool change(const QString& verb, const Words& words);
  bool run(const QString& verb, const Words& words);
  void chooseFile(const QString& name);
  void load(const QString& name, bool asking);
  void trigger(const QString& name);

  ui::MainWindow& window_;
  std::filesystem::path folder_;
};

/// Small scenes, which are built and simulated in a moment.
modeling::Scene sceneNamed(const QString& name);

}  // namespace monkey
