#include "ui/session/playback.h"

#include <catch2/catch.hpp>

#include "tests/ui/window_scenes.h"

namespace {

/// Playback of eleven frames a tenth of a second apart, by a clock that stands unless it is told.
struct Played {
  double now = 100.0;
  int changes = 0;
  ui::Playback playback{[this] { return now; }, nullptr};

  Played() {
    std::vector<double> times;
    for (int frame = 0; frame <= 10; ++frame) times.push_back(0.1 * frame);
    playback.setFootage(tests::stillFootage(times, {0, 0, 0, 5}));
    QObject::connect(&playback, &ui::Playback::frameChanged, [this] { ++changes; });
  }

  void wait(double seconds, bool shown = true) {
    now += seconds;
    playback.tick(shown);
  }
};

TEST_CASE("Playing in real time keeps to the clock and leaves frames out") {
  Played played;
  played.playback.play(1);
  played.wait(0.25);
  CHECK(played.playback.frame() == 2);
  played.wait(0.5);
  CHECK(played.playback.frame() == 7);
  CHECK(played.changes == 2);
  // Between two frames nothing new is asked for.
  played.wait(0.01);
  CHECK(played.changes == 2);
}

TEST_CASE("Slow motion is slow") {
  Played played;
  played.playback.setSpeed(0.1);
  played.playback.play(1);
  played.wait(5.05);
  CHECK(played.playback.frame() == 5);
}

TEST_CASE("Playing stops at the end it runs to, and begins anew from there") {
  Played played;
  played.playback.play(1);
  played.wait(3.0);
  CHECK(played.playback.direction() == 0);
  CHECK(played.playback.frame() == 10);
  played.playback.play(1);
  CHECK(played.playback.frame() == 0);
}

TEST_CASE("Playing backwards goes from the end to the start") {
  Played played;
  played.playback.play(-1);
  CHECK(played.playback.frame() == 10);
  played.wait(0.35);
  CHECK(played.playback.frame() == 6);
  played.wait(3.0);
  CHECK(played.playback.direction() == 0);
  CHECK(played.playback.frame() == 0);
}

TEST_CASE("A loop stays in its range, forwards and backwards") {
  Played played;
  played.playback.setLoops(true);
  played.playback.setLoopRange(ui::Playback::Range{0.3, 0.6});
  played.playback.seek(3);
  played.playback.play(1);
  for (int tick = 0; tick < 40; ++tick) {
    played.wait(0.03);
    CHECK(played.playback.time() >= 0.3);
    CHECK(played.playback.time() <= 0.6);
  }
  CHECK(played.playback.direction() == 1);
  played.playback.play(-1);
  for (int tick = 0; tick < 40; ++tick) {
    played.wait(0.03);
    CHECK(played.playback.time() >= 0.3);
    CHECK(played.playback.time() <= 0.6);
  }
}

TEST_CASE("Every frame is shown, however long each takes to come") {
  Played played;
  played.playback.setMode(ui::Playback::Mode::everyFrame);
  played.playback.play(1);
  played.wait(10.0, false);
  CHECK(played.playback.frame() == 0);
  for (std::size_t frame = 1; frame <= 10; ++frame) {
    played.wait(10.0);
    CHECK(played.playback.frame() == frame);
    played.wait(10.0, false);
    CHECK(played.playback.frame() == frame);
  }
  played.wait(10.0);
  CHECK(played.playback.direction() == 0);
}

TEST_CASE("The first break is found, and steps stay within the take") {
  Played played;
  played.playback.toFirstBreak();
  CHECK(played.playback.frame() == 3);
  played.playback.stepBy(-5);
  CHECK(played.playback.frame() == 0);
  played.playback.toLast();
  played.playback.stepBy(1);
  CHECK(played.playback.frame() == 10);
}

}  // namespace
