#pragma once

#include <QScrollArea>
#include <filesystem>

#include "ui/files/recent_files.h"

class QLabel;

namespace ui {

class CardGrid;

/// What is seen when nothing is open: how to begin, what was open lately, and the scenes that come with the
/// program.
class Gallery : public QScrollArea {
  Q_OBJECT

 public:
  explicit Gallery(RecentFiles& recent, QWidget* parent = nullptr);

  /// A scene that comes with the program, by the name of its file without the ending.
  static std::filesystem::path sceneFile(const QString& name);

 signals:
  void newWanted();
  void openWanted();
  void fileWanted(const std::filesystem::path& file);

 private:
  QWidget* makeHead();
  void addScenes();
  void showRecent();
  QLabel* heading(const QString& text);

  RecentFiles& recent_;
  QLabel* recentHeading_ = nullptr;
  CardGrid* recentCards_ = nullptr;
  CardGrid* sceneCards_ = nullptr;
};

}  // namespace ui
