#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/results/json.h"
#include "ui/plot/log_log_plot.h"

namespace app {

/// One measurement of `bench accuracy`. Errors are relative (accuracy_measure.h); absent where there was
/// nothing to compare.
struct AccuracyRow {
  std::string scene;
  std::string title;           ///< the scene's, for people
  std::string method;          ///< "reference": its errors are the difference from a run of twice the step
  bool automatic = false;      ///< the step the program chooses by itself
  double step = 0.0;           ///< s
  double stepOverLimit = 0.0;  ///< over velocity Verlet's longest stable one
  double cpuSeconds = 0.0;
  std::optional<double> position, strain, energy;
  std::optional<double> breakTime;   ///< relative, of the first break
  std::optional<double> breakPlace;  ///< cm
  double dampingRatio = 0.0;         ///< of the scene's stiffest swing; 0: not stated
  bool brief = false;                ///< of a scene that only serves to compare dampings
  double leastGain = 0.0;            ///< the scene's goal (accuracy_scenes.h); 0: none
  std::string status;                ///< "done", "blown up", "refused", "too slow"
};

Json toJson(const AccuracyRow& row);
AccuracyRow accuracyRow(const Json& json);

/// CPU time a method needs for a strain error.
struct TimeForError {
  enum class Kind {
    between,       ///< interpolated in log-log between two measurements
    atMost,        ///< the longest stable step is better than asked
    extrapolated,  ///< never reached: as if the error went on falling as the step, or faster if it did so
  };
  Kind kind = Kind::between;
  double seconds = 0.0;
};
std::optional<TimeForError> timeForStrainError(const std::vector<AccuracyRow>& rows, const std::string& scene,
                                               const std::string& method, double error);

/// What the rows say, as Markdown tables: goals, references, and each method's time for 1 % strain error.
std::string accuracyTables(const std::vector<AccuracyRow>& rows);

/// One sheet a scene.
std::vector<std::pair<std::string, ui::PlotSheet>> accuracyPlots(const std::vector<AccuracyRow>& rows);

}  // namespace app
