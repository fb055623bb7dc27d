#pragma once

#include <QImage>
#include <QObject>
#include <filesystem>
#include <vector>

namespace ui {

/// Scenes and takes that were opened or saved, the newest first, with a picture of each. Kept from one start
/// of the program to the next.
class RecentFiles : public QObject {
  Q_OBJECT

 public:
  static constexpr std::size_t kMost = 12;

  explicit RecentFiles(QObject* parent = nullptr);

  /// Those that still exist.
  std::vector<std::filesystem::path> files() const;
  void add(const std::filesystem::path& file);
  void remove(const std::filesystem::path& file);
  void clear();

  /// Null where there is none.
  QImage picture(const std::filesystem::path& file) const;
  void setPicture(const std::filesystem::path& file, const QImage& picture);

 signals:
  void changed();

 private:
  void store() const;

  std::vector<std::filesystem::path> files_;
};

}  // namespace ui
