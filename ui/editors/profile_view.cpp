#include "ui/editors/profile_view.h"

#include <algorithm>
#include <cmath>

namespace ui {
namespace {

constexpr double kNearest = 2000.0;  ///< pixels a cm
constexpr double kFarthest = 0.5;
constexpr double kCoarsePixels = 64.0;  ///< at least, between lines with numbers

}  // namespace

void ProfileView::zoom(double factor, const QPointF& at) {
  const double wanted = std::clamp(scale_ * factor, kFarthest, kNearest);
  axis_ = at + (axis_ - at) * (wanted / scale_);
  scale_ = wanted;
}

void ProfileView::frame(const Eigen::AlignedBox2d& box, const QSizeF& size) {
  if (box.isEmpty() || size.width() < 1.0 || size.height() < 1.0) return;
  constexpr double kMargin = 34.0;  ///< pixels, where the numbers of the grid stand as well
  const double reach = std::max(box.max().x(), 0.5);
  const double height = std::max(box.sizes().y(), 0.5);
  const double ghost = 0.45 * reach;
  const double across = std::max(10.0, size.width() - 2.0 * kMargin) / (reach + ghost);
  const double upwards = std::max(10.0, size.height() - 2.0 * kMargin) / height;
  scale_ = std::clamp(std::min(across, upwards), kFarthest, kNearest);
  const double left = 0.5 * (size.width() - scale_ * (reach + ghost)) + scale_ * ghost;
  axis_ = {left, 0.5 * size.height() + scale_ * box.center().y()};
}

double ProfileView::coarseGrid() const {
  const double wanted = kCoarsePixels / scale_;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= wanted) return step * power;
  return 10.0 * power;
}

double ProfileView::fineGrid() const {
  const double coarse = coarseGrid();
  const double leading = coarse / std::pow(10.0, std::floor(std::log10(coarse) + 1e-9));
  return coarse / (leading > 1.5 && leading < 3.0 ? 4.0 : 5.0);
}

}  // namespace ui
