#include "ui/session/sample_run.h"

#include <QTest>

#include <catch2/catch.hpp>

#include "modeling/scene/resources.h"
#include "ui/panels/sample_preview.h"

using namespace ui;

namespace {

modeling::Material preset(const char* name) {
  sim::Result<modeling::Material> material = modeling::presetMaterial(name);
  REQUIRE(material);
  return std::move(material).value();
}

SampleRun::View finished(const SampleRun& run) {
  REQUIRE(QTest::qWaitFor([&] { return run.view().done; }, 120000));
  return run.view();
}

}  // namespace

TEST_CASE("A sample of a soft ceramic breaks, one of rubber holds", "[sample]") {
  SampleRun run;
  run.start(preset("tipsy-turvy-ceramic"));
  const SampleRun::View ceramic = finished(run);
  CHECK_FALSE(ceramic.problem);
  CHECK(ceramic.frames.size() == SampleRun::kFrames);
  CHECK(ceramic.broke);
  run.start(preset("rubber"));
  const SampleRun::View rubber = finished(run);
  CHECK_FALSE(rubber.problem);
  CHECK_FALSE(rubber.broke);
}

TEST_CASE("Another material drops the sample that is under way", "[sample]") {
  SampleRun run;
  for (int i = 0; i < 5; ++i) run.start(preset("porcelain"));
  run.start(preset("jelly"));
  CHECK_FALSE(finished(run).broke);
  run.stop();
  CHECK(run.view().frames.empty());
}

TEST_CASE("A sample is computed while it can be seen", "[sample]") {
  SamplePreview preview;
  preview.setMaterial(preset("jelly"));
  QTest::qWait(400);
  CHECK(preview.view().frames.empty());
  preview.show();
  CHECK(QTest::qWaitFor([&] { return preview.view().done; }, 60000));
  preview.hide();
  preview.show();
  CHECK(QTest::qWaitFor([&] { return preview.view().done; }, 60000));
}
