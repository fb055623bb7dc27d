#include "app/bench/plotting.h"

#include <fstream>
#include <iterator>

#include <dlfcn.h>

#include "app/bench/scratch_folder.h"
#include "modeling/files/output_file.h"

namespace app {

sim::Status drawPlots(const ui::PlotSheet& sheet, const std::filesystem::path& stem) {
  const auto library = std::filesystem::canonical("/proc/self/exe").parent_path() / SMITHEREENS_PLOT_LIBRARY;
  // Never closed: Qt does not bear being unloaded.
  void* const loaded = dlopen(library.c_str(), RTLD_NOW);
  void* const found = loaded == nullptr ? nullptr : dlsym(loaded, ui::kDrawPlotsName);
  if (found == nullptr)
    return sim::Problem{library.string(), "the library that draws plots cannot be loaded",
                        "build the target ui_plot, or leave out the plots"};
  const ScratchFolder scratch;
  const std::filesystem::path drawn = scratch.path() / "plot";
  if (const auto saved = reinterpret_cast<decltype(&ui::savePlots)>(found)(sheet, drawn); !saved)
    return saved;
  std::error_code error;
  if (stem.has_parent_path()) std::filesystem::create_directories(stem.parent_path(), error);
  for (const char* const ending : {".png", ".svg"}) {
    std::ifstream in(drawn.string() + ending, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    if (const auto placed = modeling::replaceFile(stem.string() + ending, bytes); !placed) return placed;
  }
  return sim::Done{};
}

}  // namespace app
