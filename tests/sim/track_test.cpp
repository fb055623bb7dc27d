#include "sim/control/track.h"

#include <catch2/catch.hpp>

namespace {

using sim::Interpolation;
using sim::Track;
using sim::Vec3;

Track twoKeys(Interpolation interpolation) {
  Track track;
  track.interpolation = interpolation;
  track.keys = {{1.0, Vec3(2.0, 0.0, 0.0)}, {3.0, Vec3(6.0, 0.0, 0.0)}};
  return track;
}

TEST_CASE("a track is constant outside its keys") {
  for (const auto interpolation : {Interpolation::step, Interpolation::linear, Interpolation::smooth}) {
    const Track track = twoKeys(interpolation);
    CHECK(track.valueAt(0.0).x() == 2.0);
    CHECK(track.valueAt(3.0).x() == 6.0);
    CHECK(track.valueAt(9.0).x() == 6.0);
    CHECK(track.slopeAt(0.0).x() == 0.0);
    CHECK(track.slopeAt(9.0).x() == 0.0);
  }
}

TEST_CASE("each interpolation has its own value between keys") {
  CHECK(twoKeys(Interpolation::step).valueAt(2.999).x() == 2.0);
  CHECK(twoKeys(Interpolation::linear).valueAt(1.5).x() == Approx(3.0));
  CHECK(twoKeys(Interpolation::smooth).valueAt(2.0).x() == Approx(4.0));
}

TEST_CASE("the slope is the derivative of the value") {
  constexpr double width = 1e-6;
  for (const auto interpolation : {Interpolation::linear, Interpolation::smooth}) {
    const Track track = twoKeys(interpolation);
    for (const double time : {1.1, 1.7, 2.0, 2.9}) {
      const double quotient =
          (track.valueAt(time + width).x() - track.valueAt(time - width).x()) / (2.0 * width);
      CHECK(track.slopeAt(time).x() == Approx(quotient).margin(1e-8));
    }
  }
}

}  // namespace
