#include "ui/viewport/draw_feed.h"

#include "ui/session/session.h"

namespace ui {
namespace {

/// How often it is looked whether draw data is ready.
constexpr int kPreparingMilliseconds = 8;

}  // namespace

DrawFeed::DrawFeed(Session& session, QObject* parent)
    : QObject(parent), session_(session), drawn_(std::make_shared<const DrawData>()) {
  preparing_.setInterval(kPreparingMilliseconds);
  preparing_.setTimerType(Qt::PreciseTimer);
  connect(&preparing_, &QTimer::timeout, this, &DrawFeed::takePrepared);
  connect(&session_, &Session::shownChanged, this, &DrawFeed::prepare);
  connect(&session_.document(), &Document::sceneChanged, this, &DrawFeed::prepareIfHidden);
  prepare();
}

void DrawFeed::setSettings(const ViewSettings& settings) {
  settings_ = settings;
  prepare();
}

ViewSettings DrawFeed::effectiveSettings() const {
  ViewSettings settings = settings_;
  const std::vector<std::string>& hidden = session_.document().scene().view.hidden;
  settings.hiddenParts.insert(settings.hiddenParts.end(), hidden.begin(), hidden.end());
  return settings;
}

void DrawFeed::prepareIfHidden() {
  if (effectiveSettings() != requested_) prepare();
}

void DrawFeed::prepare() {
  requested_ = effectiveSettings();
  preparer_.request(session_.shown(), requested_);
  preparing_.start();
}

void DrawFeed::takePrepared() {
  // Asked before the newest is taken: what is ready in between comes with the next look.
  if (!preparer_.isBusy()) preparing_.stop();
  std::shared_ptr<const DrawData> newest = preparer_.newest();
  if (newest == drawn_) return;
  drawn_ = std::move(newest);
  emit changed();
  if (const std::optional<sim::Problem> problem = preparer_.problem()) emit failed(*problem);
}

bool DrawFeed::isUpToDate() const {
  const Shown& shown = session_.shown();
  return !preparer_.isBusy() && drawn_ == preparer_.newest() && drawn_->settings == effectiveSettings() &&
         drawn_->shown.network == shown.network && drawn_->shown.moment == shown.moment;
}

}  // namespace ui
