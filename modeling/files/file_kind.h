#pragma once

#include <filesystem>
#include <string_view>

namespace modeling {

/// A kind of file that the program writes, known by its content, whatever its name is.
struct FileKind {
  const char* name;                       ///< as in "this is not ..."
  bool (*begins)(std::string_view text);  ///< whether a file of the kind may begin so
  bool grows = false;                     ///< written in place, which takes a file that can be cut and locked
};

namespace kinds {

extern const FileKind take, png, glb;
extern const FileKind report;  ///< of a run
extern const FileKind table;   ///< JSON: rows with names, as sweeps and benchmarks leave them
extern const FileKind scene;
extern const FileKind csv;  ///< with the heads of our own tables
extern const FileKind xyz, obj, mtl, ply, pc2, vtk;
extern const FileKind lammps;       ///< data or input, as we write it
extern const FileKind slurm, log;   ///< as a sweep writes them
extern const FileKind keptPicture;  ///< a picture that is being drawn
extern const FileKind film, svg;
extern const FileKind benchmarks;  ///< the page that has marks for them

}  // namespace kinds

/// Whether what is there may be replaced by a file of the kind: it is one, or empty. Looks at the first
/// 64 KiB.
bool isOfKind(const std::filesystem::path& file, const FileKind& kind);

}  // namespace modeling
