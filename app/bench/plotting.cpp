#include "app/bench/plotting.h"

#include <dlfcn.h>

namespace app {

sim::Status drawPlots(const ui::PlotSheet& sheet, const std::filesystem::path& stem) {
  const auto library = std::filesystem::canonical("/proc/self/exe").parent_path() / SMITHEREENS_PLOT_LIBRARY;
  // Never closed: Qt does not bear being unloaded.
  void* const loaded = dlopen(library.c_str(), RTLD_NOW);
  void* const found = loaded == nullptr ? nullptr : dlsym(loaded, ui::kDrawPlotsName);
  if (found == nullptr)
    return sim::Problem{library.string(), "the library that draws plots cannot be loaded",
                        "build the target ui_plot, or leave out the plots"};
  return reinterpret_cast<decltype(&ui::savePlots)>(found)(sheet, stem);
}

}  // namespace app
