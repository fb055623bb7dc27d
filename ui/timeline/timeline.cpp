#include "ui/timeline/timeline.h"

#include <QAction>
#include <QMenu>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/document/track_titles.h"
#include "ui/session/session.h"
#include "ui/theme/theme.h"
#include "ui/timeline/play_actions.h"
#include "ui/timeline/time_bar.h"
#include "ui/timeline/track_rows.h"
#include "ui/timeline/transport.h"

namespace ui {
namespace {

/// px: with more tracks than fit one scrolls.
constexpr int kMostTrackHeight = TrackLayout::kExpandedHeight + 2 * TrackLayout::kRowHeight;

}  // namespace

Timeline::Timeline(Session& session, PlayActions& actions, QWidget* parent)
    : QWidget(parent), session_(session), feed_(session) {
  setObjectName(QStringLiteral("timeline"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  transport_ = new Transport(session_, actions, this);
  bar_ = new TimeBar(session_, axis_, feed_, actions, this);
  makeTracks();
  column->addWidget(bar_);
  column->addWidget(scroll_, 1);
  // At the window's edge: tracks that come and go do not move it under the pointer.
  column->addWidget(transport_);
  connect(&session_.document(), &Document::sceneChanged, this, &Timeline::fitAxis);
  connect(&session_.document(), &Document::sceneChanged, this, &Timeline::fitTracks);
  connect(rows_, &TrackRows::heightChanged, this, &Timeline::fitTracks);
  connect(&feed_, &NoteFeed::reset, this, &Timeline::fitAxis);
  connect(&feed_, &NoteFeed::grown, this, &Timeline::fitAxis);
  fitAxis();
  fitTracks();
}

void Timeline::makeTracks() {
  rows_ = new TrackRows(session_, axis_, *bar_, this);
  scroll_ = new QScrollArea(this);
  scroll_->setWidget(rows_);
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFrameShape(QFrame::NoFrame);
  targets_ = new QMenu(this);
  connect(targets_, &QMenu::aboutToShow, this, &Timeline::fillTargets);
  addTrack_ = new QAction(Theme::icon(QStringLiteral("add-track")), tr("Add Track"), this);
  addTrack_->setToolTip(tr("Add a track: a value that varies in time"));
  transport_->addButton(addTrack_, targets_);
  showTracks_ = new QAction(Theme::icon(QStringLiteral("tracks")), tr("Show Tracks"), this);
  showTracks_->setCheckable(true);
  showTracks_->setToolTip(tr("Show the tracks: values that vary in time"));
  transport_->addButton(showTracks_);
  connect(showTracks_, &QAction::toggled, this, &Timeline::fitTracks);
}

void Timeline::fillTargets() {
  targets_->clear();
  for (const modeling::TargetName& target : modeling::targetsOf(session_.document().scene())) {
    connect(targets_->addAction(titleOf(target)), &QAction::triggered, this, [this, target] {
      session_.document().edit(tr("Add Track"), [&](modeling::Scene& scene) { addTrack(scene, target); });
      showTracks_->setChecked(true);
      rows_->setExpanded(session_.document().scene().tracks.size() - 1, true);
    });
  }
}

void Timeline::fitAxis() {
  const double recorded = feed_.notes().empty() ? 0.0 : feed_.notes().back().time;
  axis_.setEnd(std::max(session_.document().scene().output.duration, recorded));
}

/// The first track that comes shows itself.
void Timeline::fitTracks() {
  const std::size_t count = session_.document().scene().tracks.size();
  if (std::exchange(trackCount_, count) == 0 && count > 0) showTracks_->setChecked(true);
  const bool shown = showTracks_->isChecked();
  scroll_->setVisible(shown);
  scroll_->setMinimumHeight(std::min(rows_->sizeHint().height(), kMostTrackHeight));
  const int rest = transport_->sizeHint().height() + bar_->sizeHint().height();
  // No higher than what there is to show: the room is the picture's.
  setMaximumHeight(shown ? rest + rows_->sizeHint().height() : rest);
}

}  // namespace ui
