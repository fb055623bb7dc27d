#include "ui/editors/curve_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "modeling/shapes/measured_chain.h"

namespace ui {
namespace {

using modeling::CubicSegment;
using modeling::Vec2;

/// Rounds of moving each sample's parameter to the nearest point of the curve; more change little.
constexpr int kRounds = 8;

std::vector<double> chordParameters(const std::vector<CurveSample>& samples, std::size_t begin,
                                    std::size_t end) {
  std::vector<double> parameters{0.0};
  for (std::size_t i = begin + 1; i <= end; ++i)
    parameters.push_back(parameters.back() + (samples[i].at - samples[i - 1].at).norm());
  const double length = parameters.back();
  for (double& parameter : parameters) parameter = length > 0.0 ? parameter / length : 0.0;
  return parameters;
}

/// Least squares for the lengths of the two handles, whose directions are given.
CubicSegment<Vec2> leastSquares(const std::vector<CurveSample>& samples, std::size_t begin, std::size_t end,
                                const std::vector<double>& parameters) {
  const Vec2 first = samples[begin].at;
  const Vec2 last = samples[end].at;
  const Vec2 leaving = samples[begin].along;
  const Vec2 arriving = -samples[end].along;
  Eigen::Matrix2d sums = Eigen::Matrix2d::Zero();
  Vec2 right = Vec2::Zero();
  for (std::size_t i = begin; i <= end; ++i) {
    const double t = parameters[i - begin];
    const double s = 1.0 - t;
    const Vec2 one = 3.0 * s * s * t * leaving;
    const Vec2 two = 3.0 * s * t * t * arriving;
    const Vec2 rest = samples[i].at - (s * s * (s + 3.0 * t) * first + t * t * (t + 3.0 * s) * last);
    sums += Eigen::Matrix2d{{one.dot(one), one.dot(two)}, {two.dot(one), two.dot(two)}};
    right += Vec2(one.dot(rest), two.dot(rest));
  }
  const double chord = (last - first).norm();
  Vec2 lengths(chord / 3.0, chord / 3.0);
  if (sums.determinant() > 1e-12 * sums.squaredNorm()) {
    const Vec2 solved = sums.inverse() * right;
    // A handle that points backwards or far beyond the other end makes a loop.
    if (solved.minCoeff() > 1e-3 * chord && solved.maxCoeff() < 3.0 * chord) lengths = solved;
  }
  return {first, Vec2(first + lengths[0] * leaving), Vec2(last + lengths[1] * arriving), last};
}

double nearerParameter(const CubicSegment<Vec2>& p, const Vec2& sample, double t) {
  const Vec2 away = modeling::evaluate(p, t) - sample;
  const Vec2 slope = modeling::derivative(p, t);
  const Vec2 bend = 6.0 * ((1.0 - t) * (p[2] - 2.0 * p[1] + p[0]) + t * (p[3] - 2.0 * p[2] + p[1]));
  const double denominator = slope.squaredNorm() + away.dot(bend);
  if (!(std::abs(denominator) > 1e-12)) return t;
  return std::clamp(t - away.dot(slope) / denominator, 0.0, 1.0);
}

}  // namespace

CurveFit fitSegment(const std::vector<CurveSample>& samples, std::size_t begin, std::size_t end) {
  std::vector<double> parameters = chordParameters(samples, begin, end);
  CurveFit fit;
  for (int round = 0; round <= kRounds; ++round) {
    fit.segment = leastSquares(samples, begin, end, parameters);
    for (std::size_t i = begin + 1; i < end; ++i) {
      double& parameter = parameters[i - begin];
      parameter = nearerParameter(fit.segment, samples[i].at, parameter);
    }
  }
  fit.worstSample = (begin + end) / 2;
  for (std::size_t i = begin + 1; i < end; ++i) {
    const double distance = (modeling::evaluate(fit.segment, parameters[i - begin]) - samples[i].at).norm();
    if (distance > fit.worst) fit = {fit.segment, distance, i};
  }
  return fit;
}

modeling::ProfileChain fitChain(const std::vector<CurveSample>& samples, std::size_t begin, std::size_t end,
                                double tolerance, std::vector<std::size_t>& breaks) {
  const CurveFit fit = fitSegment(samples, begin, end);
  if (fit.worst <= tolerance || end - begin < 4) return {fit.segment};
  const std::size_t middle = std::clamp(fit.worstSample, begin + 2, end - 2);
  modeling::ProfileChain chain = fitChain(samples, begin, middle, tolerance, breaks);
  breaks.push_back(middle);
  const modeling::ProfileChain rest = fitChain(samples, middle, end, tolerance, breaks);
  chain.insert(chain.end(), rest.begin(), rest.end());
  return chain;
}

}  // namespace ui
