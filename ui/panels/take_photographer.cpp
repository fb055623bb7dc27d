#include "ui/panels/take_photographer.h"

#include "ui/session/session.h"
#include "ui/viewport/viewport.h"

namespace ui {
namespace {

/// Device pixels; twice as large as it is shown, for screens of high resolution.
constexpr QSize kPicture(176, 112);

QImage cropped(const QImage& picture) {
  const QSize size = kPicture.scaled(picture.size(), Qt::KeepAspectRatio);
  const QPoint corner((picture.width() - size.width()) / 2, (picture.height() - size.height()) / 2);
  QImage made =
      picture.copy(QRect(corner, size)).scaled(kPicture, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  made.setDevicePixelRatio(1.0);
  return made;
}

}  // namespace

TakePhotographer::TakePhotographer(Session& session, Viewport& viewport, QObject* parent)
    : QObject(parent), session_(session), viewport_(viewport) {
  connect(&session_, &Session::runChanged, this, &TakePhotographer::look);
}

void TakePhotographer::look() {
  const RunView& run = *session_.run();
  if (!run.footage || !run.newest || run.run == shotRun_) return;
  const bool done = run.phase == RunPhase::done || run.phase == RunPhase::failed;
  const bool seen = session_.shown().recorded && session_.shown().network == run.footage->network();
  if (!seen) return;
  const std::optional<double> broke = run.footage->firstBreak();
  const bool ripe = broke && run.newest->time >= *broke + (run.until - *broke) / 3.0;
  if (!ripe && !done) return;
  shotRun_ = run.run;
  shoot();
}

void TakePhotographer::shoot() {
  if (!viewport_.isVisible() || !viewport_.isValid()) return;
  const TakeList& takes = session_.takes();
  for (std::size_t take = 0; take < takes.size(); ++take) {
    if (takes[take].footage == session_.run()->footage)
      session_.takes().setThumbnail(take, cropped(viewport_.grabFramebuffer()));
  }
}

}  // namespace ui
