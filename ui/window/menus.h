#pragma once

#include <functional>

#include "ui/window/window_actions.h"

class QMainWindow;

namespace ui {

class Docks;
class Session;
class Viewport;

/// What the menus lead to.
struct MenuTargets {
  QMainWindow& window;
  Session& session;
  Viewport& viewport;
  Docks& docks;
  const WindowActions& actions;
  std::function<void()> showGallery;
};

/// Makes the menus of the window, and with them what is found there only: views, themes, help.
void makeMenus(const MenuTargets& targets);

}  // namespace ui
