#pragma once

namespace ui {

class AddActions;
class EditorActions;
class FileActions;
class PlayActions;
class SceneActions;

/// What the window can do, by what it does it to. Menus, docks and bars offer it; it belongs to the window.
struct WindowActions {
  FileActions* files = nullptr;
  SceneActions* scene = nullptr;
  AddActions* add = nullptr;
  PlayActions* play = nullptr;
  EditorActions* editors = nullptr;
};

}  // namespace ui
