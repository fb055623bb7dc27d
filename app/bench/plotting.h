#pragma once

#include <filesystem>

#include "ui/plot/log_log_plot.h"

namespace app {

/// ui::savePlots from its library, loaded at the first call: what draws nothing starts without Qt.
sim::Status drawPlots(const ui::PlotSheet& sheet, const std::filesystem::path& stem);

}  // namespace app
