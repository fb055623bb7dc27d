#include "app/bench/triad.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

namespace app {
namespace {

constexpr std::size_t kNumbers = 12'000'000;  ///< in each array: 96 MB
constexpr int kRepeats = 7;

/// Left uninitialised, so that each thread's first touch places its own pages.
struct Arrays {
  std::unique_ptr<double[]> a{new double[kNumbers]};
  std::unique_ptr<double[]> b{new double[kNumbers]};
  std::unique_ptr<double[]> c{new double[kNumbers]};
};

template <class Work>
void share(int threads, const Work& work) {
  std::vector<std::jthread> running;
  const auto count = static_cast<std::size_t>(threads);
  for (std::size_t t = 0; t < count; ++t)
    running.emplace_back([&work, t, count] { work(kNumbers * t / count, kNumbers * (t + 1) / count); });
}

}  // namespace

double triadBandwidth(int threads) {
  const Arrays arrays;
  share(threads, [&](std::size_t begin, std::size_t end) {
    std::fill(&arrays.a[begin], &arrays.a[0] + end, 0.0);
    std::fill(&arrays.b[begin], &arrays.b[0] + end, 1.0);
    std::fill(&arrays.c[begin], &arrays.c[0] + end, 2.0);
  });
  double best = 1e300;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    share(threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) arrays.a[i] = arrays.b[i] + 3.0 * arrays.c[i];
    });
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return 3.0 * sizeof(double) * static_cast<double>(kNumbers) / best;
}

}  // namespace app
