#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/result.h"

/// Plots for documents: drawn without a window, readable in print and by the colour-blind.
namespace ui {

/// A line with a point at each measurement.
struct PlotSeries {
  std::string name;                           ///< written beside the line
  std::string colour;                         ///< "#rrggbb"
  std::vector<std::array<double, 2>> points;  ///< (x, y), each above 0, in order along the line
  bool strong = false;                        ///< drawn thicker: what the plot is about
};

/// Both axes logarithmic.
struct LogLogPlot {
  std::string title;
  std::string xTitle;  ///< with its unit
  std::string yTitle;
  std::vector<PlotSeries> series;
  std::optional<double> goal;  ///< a level of y to be compared with
  std::string goalName;
};

/// Plots side by side under one heading.
struct PlotSheet {
  std::string title;
  std::vector<LogLogPlot> plots;
};

/// Writes stem + ".png", at twice the size of the page, and stem + ".svg". Lives in a library of its own,
/// which a program may load when it first draws; so it has a name that can be looked up.
__attribute__((visibility("default"))) sim::Status savePlots(
    const PlotSheet& sheet, const std::filesystem::path& stem) __asm__("smithereens_save_plots");
inline constexpr const char* kDrawPlotsName = "smithereens_save_plots";

}  // namespace ui
