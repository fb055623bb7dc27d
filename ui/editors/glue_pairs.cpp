#include "ui/editors/glue_pairs.h"

#include <algorithm>

#include "ui/editors/glue_tool.h"
#include "ui/theme/theme.h"
#include "ui/viewport/overlay.h"
#include "ui/viewport/viewport.h"

namespace ui {
namespace {

constexpr int kPollMilliseconds = 30;

/// Where the parts of a gluing stand, one middle to the other.
GlueLink betweenParts(const modeling::Scene& scene, const modeling::Gluing& gluing) {
  GlueLink link;
  for (const modeling::Part& part : scene.parts) {
    if (part.name == gluing.a) link.atA = part.worldFromPart.position;
    if (part.name == gluing.b) link.atB = part.worldFromPart.position;
  }
  return link;
}

}  // namespace

GluePairs::GluePairs(Session& session, Viewport& viewport)
    : QObject(&viewport),
      session_(session),
      viewport_(viewport),
      worker_(
          [previewer = std::make_shared<GluePreviewer>()](const Request& request, auto& job) -> sim::Status {
            Found& found = job.value;
            for (std::size_t gluing = 0; gluing < request.scene.glue.size() && !job.cancelled(); ++gluing) {
              const bool fails = std::ranges::find(request.failing, gluing) != request.failing.end();
              if (!request.all && !fails) continue;
              const GlueOutcome outcome = previewer->outcome(request.scene, gluing, request.folder);
              found.links.insert(found.links.end(), outcome.links.begin(), outcome.links.end());
              if (fails)
                found.failed.push_back(outcome.nearest.value_or(betweenParts(request.scene, outcome.gluing)));
            }
            return sim::Done{};
          }) {
  timer_.setInterval(kPollMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &GluePairs::poll);
  connect(&session_.document(), &Document::sceneChanged, this, &GluePairs::request);
  connect(&viewport_, &Viewport::viewSettingsChanged, this, &GluePairs::request);
  connect(&session_, &Session::shownChanged, this, [this] {
    if (areSeen() == found_.links.empty()) request();
  });
  connect(&session_, &Session::previewChanged, this, &GluePairs::request);
  viewport_.addOverlay([this](Overlay& overlay) { draw(overlay); });
  request();
}

bool GluePairs::areSeen() const {
  return viewport_.viewSettings().gluePairs && !session_.shown().recorded;
}

std::vector<std::size_t> GluePairs::failing() const {
  const Preview& preview = *session_.preview();
  std::vector<std::size_t> failing;
  if (session_.shown().recorded || preview.scene.glue != session_.document().scene().glue) return failing;
  for (const Preview::FailedGluing& failed : preview.failedGluings) failing.push_back(failed.gluing);
  return failing;
}

void GluePairs::request() {
  std::vector<std::size_t> failing = this->failing();
  if (!areSeen() && failing.empty()) {
    found_ = {};
    timer_.stop();
    viewport_.update();
    return;
  }
  worker_.request({session_.document().scene(), session_.document().folder(), areSeen(), std::move(failing)});
  timer_.start();
}

void GluePairs::poll() {
  if (worker_.isBusy()) return;
  timer_.stop();
  found_ = worker_.newest()->value;
  viewport_.update();
}

void GluePairs::draw(Overlay& overlay) const {
  // The tool shows its own.
  if (session_.shown().recorded || dynamic_cast<const GlueTool*>(viewport_.tool()) != nullptr) return;
  const Colours& colours = Theme::instance().colours();
  for (const GlueLink& link : found_.failed) {
    overlay.line(link.atA, link.atB, colours.bad, 3.0);
    overlay.point(link.atA, colours.bad, 8.0);
    overlay.point(link.atB, colours.bad, 8.0);
    overlay.text(0.5 * (link.atA + link.atB), tr("not glued: %1 cm apart").arg(link.distance(), 0, 'g', 3),
                 colours.bad);
  }
  if (!areSeen()) return;
  for (const GlueLink& link : found_.links) {
    overlay.line(link.atA, link.atB, colours.warning, 2.0);
    overlay.point(link.atA, colours.warning, 6.0);
    overlay.point(link.atB, colours.accent, 5.0);
  }
}

}  // namespace ui
