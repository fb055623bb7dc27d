#include "modeling/files/file_kind.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "sim/take/chunk.h"

namespace modeling {
namespace {

constexpr std::size_t kStart = 64UL * 1024;

/// The names of members that stand at a depth of a JSON text, as far as it goes: 1 is the outermost object's.
class NamesAtDepth : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit NamesAtDepth(int depth) : depth_(depth) {}
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return ++now_, true; }
  bool end_object() override { return --now_, true; }
  bool start_array(std::size_t) override { return ++now_, true; }
  bool end_array() override { return --now_, true; }
  bool key(string_t& name) override {
    if (now_ == depth_) names.insert(name);
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

  std::set<std::string> names;

 private:
  int depth_;
  int now_ = 0;
};

char firstLetter(std::string_view text) {
  const auto at = text.find_first_not_of(" \t\r\n");
  return at == std::string_view::npos ? '\0' : text[at];
}

std::set<std::string> namesAt(int depth, std::string_view text) {
  NamesAtDepth reader(depth);
  nlohmann::json::sax_parse(text.begin(), text.end(), &reader);
  return std::move(reader.names);
}

bool has(const std::set<std::string>& names, std::initializer_list<const char*> wanted) {
  return std::all_of(wanted.begin(), wanted.end(), [&](const char* name) { return names.contains(name); });
}

bool isTake(std::string_view text) {
  const auto magic = sim::chunkMagic();
  return text.starts_with({reinterpret_cast<const char*>(magic.data()), magic.size()});
}

bool isPng(std::string_view text) {
  return text.starts_with("\x89PNG\r\n\x1a\n");
}

bool isReport(std::string_view text) {
  return firstLetter(text) == '{' && has(namesAt(1, text), {"nodes", "bonds", "state_hash"});
}

/// Rows of sweeps have a run and its outcome, those of benchmarks a scene or a group of cases.
bool isTable(std::string_view text) {
  if (firstLetter(text) != '[') return false;
  const std::set<std::string> names = namesAt(2, text);
  return text.find_first_not_of("[] \t\r\n") == std::string_view::npos || has(names, {"run", "outcome"}) ||
         has(names, {"scene"}) || has(names, {"group"});
}

bool isScene(std::string_view text) {
  return firstLetter(text) == '{' && has(namesAt(1, text), {"smithereens"});
}

bool isCsv(std::string_view text) {
  return text.starts_with("frame,time_s,") || text.starts_with("run,");
}

/// How many atoms, and what is known of each.
bool isXyz(std::string_view text) {
  const auto line = text.find('\n');
  const std::string_view count = text.substr(0, line);
  const bool number = count.find_first_not_of("0123456789 \t\r") == std::string_view::npos;
  const std::string_view second =
      line == std::string_view::npos ? "" : text.substr(line + 1, text.find('\n', line + 1) - line - 1);
  return number && second.find("Properties=") != std::string_view::npos;
}

/// Whether some line begins so.
bool hasLine(std::string_view text, std::string_view start) {
  for (std::size_t at = 0; at < text.size();) {
    if (text.substr(at).starts_with(start)) return true;
    const auto end = text.find('\n', at);
    if (end == std::string_view::npos) return false;
    at = end + 1;
  }
  return false;
}

bool isObj(std::string_view text) {
  return hasLine(text, "v ") || hasLine(text, "mtllib ");
}

bool isMtl(std::string_view text) {
  return hasLine(text, "newmtl ");
}

bool isVtk(std::string_view text) {
  return text.starts_with("<?xml") && text.find("<VTKFile") != std::string_view::npos;
}

bool isSvg(std::string_view text) {
  return text.starts_with("<?xml") && text.find("<svg") != std::string_view::npos;
}

bool isLammps(std::string_view text) {
  return text.starts_with("Smithereens, ") || text.starts_with("# Smithereens: ");
}

bool isSlurm(std::string_view text) {
  return text.starts_with("#!/bin/bash\n#SBATCH --job-name=smithereens-sweep\n");
}

bool isFilm(std::string_view text) {
  const bool quicktime = text.size() > 8 && text.substr(4, 4) == "ftyp";
  const bool webp = text.starts_with("RIFF") && text.size() > 12 && text.substr(8, 4) == "WEBP";
  return quicktime || webp || text.starts_with("\x1a\x45\xdf\xa3") || text.starts_with("GIF8") || isPng(text);
}

}  // namespace

namespace kinds {

const FileKind take{"a take", isTake, true};
const FileKind png{"a PNG picture", isPng};
const FileKind glb{"a glb file", [](std::string_view text) { return text.starts_with("glTF"); }};
const FileKind report{"a report of a run", isReport};
const FileKind table{"a table of results", isTable};
const FileKind scene{"a scene", isScene};
const FileKind csv{"a table of ours", isCsv};
const FileKind xyz{"an extended XYZ file", isXyz};
const FileKind obj{"an OBJ file", isObj};
const FileKind mtl{"a library of materials", isMtl};
const FileKind ply{"a PLY file", [](std::string_view text) {
                     return text.starts_with("ply\n") || text.starts_with("ply\r\n");
                   }};
const FileKind pc2{"a point cache", [](std::string_view text) { return text.starts_with("POINTCACHE2"); }};
const FileKind vtk{"a VTK file", isVtk};
const FileKind lammps{"an export to LAMMPS", isLammps};
const FileKind slurm{"a script of a sweep", isSlurm};
const FileKind log{"a log of a sweep",
                   [](std::string_view text) { return text.starts_with("# smithereens-cli "); }};
const FileKind keptPicture{"a picture being drawn",
                           [](std::string_view text) { return text.starts_with("ptures0T"); }};
const FileKind film{"a film", isFilm};
const FileKind svg{"an SVG drawing", isSvg};
const FileKind benchmarks{"a page for benchmarks", [](std::string_view text) {
                            return text.find("<!-- begin ") != std::string_view::npos;
                          }};

}  // namespace kinds

bool isOfKind(const std::filesystem::path& file, const FileKind& kind) {
  std::error_code error;
  if (std::filesystem::file_size(file, error) == 0) return true;
  std::ifstream stream(file, std::ios::binary);
  std::string start(kStart, '\0');
  stream.read(start.data(), static_cast<std::streamsize>(kStart));
  start.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
  return kind.begins(start);
}

}  // namespace modeling
