#pragma once

#include <vector>

#include "modeling/exchange/export.h"
#include "modeling/exchange/rigid_fit.h"
#include "sim/surface/surface_mesh.h"

namespace modeling {

/// The exported frames as fragments that move rigidly.
struct FragmentMotion {
  double framesPerSecond = 24.0;
  std::vector<double> times;  ///< s from the first frame
  std::vector<FinalFragment> fragments;
  std::vector<std::vector<Pose>> poses;  ///< one list a fragment, one pose a frame
  std::vector<FitResidual> residuals;    ///< one a fragment
  sim::Snapshot split;                   ///< the first frame's positions, broken as the last frame is
};

/// Times are whole frames where the take's are, but for less than a step: a frame is recorded at the first
/// step behind its time. A Problem where a frame cannot be read or the request was cancelled; progress is
/// told up to `share`.
sim::Result<FragmentMotion> fragmentMotion(const sim::TakeReader& take, const ExportRequest& request,
                                           double share);

}  // namespace modeling
