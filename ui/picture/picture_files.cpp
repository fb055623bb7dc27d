#include "ui/picture/picture_files.h"

#include "modeling/exchange/export.h"
#include "modeling/files/output_file.h"
#include "ui/picture/video.h"

namespace ui {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMark = ".smithereens-frames";

fs::path folderOf(const fs::path& film) {
  return film.string() + ".frames";
}

bool isOurs(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / kMark, error);
}

}  // namespace

fs::path keptFile(const fs::path& picture) {
  return picture.string() + ".partial";
}

std::vector<modeling::PlannedFile> pictureFiles(const fs::path& out, std::size_t first, std::size_t last,
                                                bool numbered, bool kept) {
  if (isVideoPath(out)) return {{out, &modeling::kinds::film}};
  std::vector<modeling::PlannedFile> files;
  for (std::size_t frame = first; frame <= last; ++frame) {
    const fs::path picture = numbered ? modeling::numberedPath(out, frame) : out;
    files.push_back({picture, &modeling::kinds::png});
    if (kept) files.push_back({keptFile(picture), &modeling::kinds::keptPicture});
  }
  return files;
}

sim::Status FilmFolder::check(const fs::path& film) {
  const fs::path folder = folderOf(film);
  std::error_code error;
  if (!fs::exists(fs::symlink_status(folder, error)) || isOurs(folder)) return sim::Done{};
  return sim::Problem{folder.string(), "the frames would be drawn here, but there is something of that name",
                      "move it away, or name another film"};
}

sim::Result<FilmFolder> FilmFolder::open(const fs::path& film) {
  if (const sim::Status good = check(film); !good) return good.problem();
  const FilmFolder folder(folderOf(film));
  std::error_code error;
  fs::create_directories(folder.path_, error);
  if (error) return sim::Problem{folder.path_.string(), "the folder cannot be made", "choose another place"};
  if (isOurs(folder.path_)) return folder;
  const sim::Status marked = modeling::replaceFile(
      folder.path_ / kMark,
      "Frames of a film that smithereens is drawing. The folder goes when it is done.\n");
  if (!marked) return marked.problem();
  return folder;
}

fs::path FilmFolder::picture(std::size_t frame) const {
  return modeling::numberedPath(path_ / "frame.png", frame);
}

void FilmFolder::remove() const {
  std::error_code error;
  std::vector<fs::path> ours{path_ / kMark};
  for (const auto& entry : fs::directory_iterator(path_, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("frame.") && (name.ends_with(".png") || name.ends_with(".png.partial")))
      ours.push_back(entry.path());
  }
  for (const fs::path& file : ours) fs::remove(file, error);
  fs::remove(path_, error);
}

}  // namespace ui
