#pragma once

namespace app {

/// Memory bandwidth of this machine, bytes a second: a = b + s c over arrays far larger than any cache, 24
/// bytes an element (STREAM's triad and way of counting), the best of several runs.
double triadBandwidth(int threads);

}  // namespace app
