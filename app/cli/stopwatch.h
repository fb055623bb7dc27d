#pragma once

namespace app {

/// Seconds since it was made, on the clock and on all processors.
class Stopwatch {
 public:
  Stopwatch();
  double wallSeconds() const;
  double cpuSeconds() const;

 private:
  double wallStart_;
  double cpuStart_;
};

}  // namespace app
