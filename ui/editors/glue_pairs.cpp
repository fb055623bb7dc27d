#include "ui/editors/glue_pairs.h"

#include "ui/editors/glue_tool.h"
#include "ui/theme/theme.h"
#include "ui/viewport/overlay.h"
#include "ui/viewport/viewport.h"

namespace ui {
namespace {

constexpr int kPollMilliseconds = 30;

}  // namespace

GluePairs::GluePairs(Session& session, Viewport& viewport)
    : QObject(&viewport),
      session_(session),
      viewport_(viewport),
      worker_(
          [previewer = std::make_shared<GluePreviewer>()](const Request& request, auto& job) -> sim::Status {
            std::vector<GlueLink>& links = job.value;
            for (std::size_t gluing = 0; gluing < request.scene.glue.size() && !job.cancelled(); ++gluing) {
              const GlueOutcome outcome = previewer->outcome(request.scene, gluing, request.folder);
              links.insert(links.end(), outcome.links.begin(), outcome.links.end());
            }
            return sim::Done{};
          }) {
  timer_.setInterval(kPollMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &GluePairs::poll);
  connect(&session_.document(), &Document::sceneChanged, this, &GluePairs::request);
  connect(&viewport_, &Viewport::viewSettingsChanged, this, &GluePairs::request);
  connect(&session_, &Session::shownChanged, this, [this] {
    if (areSeen() == links_.empty()) request();
  });
  viewport_.addOverlay([this](Overlay& overlay) { draw(overlay); });
  request();
}

bool GluePairs::areSeen() const {
  return viewport_.viewSettings().gluePairs && !session_.shown().recorded;
}

void GluePairs::request() {
  if (!areSeen()) {
    links_.clear();
    timer_.stop();
    return;
  }
  worker_.request({session_.document().scene(), session_.document().folder()});
  timer_.start();
}

void GluePairs::poll() {
  if (worker_.isBusy()) return;
  timer_.stop();
  links_ = worker_.newest()->value;
  viewport_.update();
}

void GluePairs::draw(Overlay& overlay) const {
  // The tool shows its own.
  if (!areSeen() || dynamic_cast<const GlueTool*>(viewport_.tool()) != nullptr) return;
  const Colours& colours = Theme::instance().colours();
  for (const GlueLink& link : links_) {
    overlay.line(link.atA, link.atB, colours.warning, 2.0);
    overlay.point(link.atA, colours.warning, 6.0);
    overlay.point(link.atB, colours.accent, 5.0);
  }
}

}  // namespace ui
