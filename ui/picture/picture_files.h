#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "modeling/files/output_guard.h"

namespace ui {

/// The files that pictures of frames [first, last] are written to, of which kinds: the path itself, numbered
/// ones, or a film. `kept` counts what is written beside each until it is done.
std::vector<modeling::PlannedFile> pictureFiles(const std::filesystem::path& out, std::size_t first,
                                                std::size_t last, bool numbered, bool kept);

/// Where a picture is kept while it is being drawn: "NAME.png.partial".
std::filesystem::path keptFile(const std::filesystem::path& picture);

/// The folder beside a film in which its frames are drawn, "FILM.frames". It has a mark by which it is known
/// as ours: one without is never touched.
class FilmFolder {
 public:
  /// Whether it can be made, or is ours from before.
  static sim::Status check(const std::filesystem::path& film);
  /// Makes it, or goes on with ours from before.
  static sim::Result<FilmFolder> open(const std::filesystem::path& film);

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path picture(std::size_t frame) const;
  /// As ffmpeg wants it: with %04d for the number.
  std::filesystem::path pattern() const { return path_ / "frame.%04d.png"; }
  /// Removes what the program puts there, and the folder where nothing else is in it.
  void remove() const;

 private:
  explicit FilmFolder(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path path_;
};

}  // namespace ui
