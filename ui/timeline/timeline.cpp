#include "ui/timeline/timeline.h"

#include <QVBoxLayout>

#include "ui/session/session.h"
#include "ui/timeline/play_actions.h"
#include "ui/timeline/time_bar.h"
#include "ui/timeline/transport.h"

namespace ui {

Timeline::Timeline(Session& session, PlayActions& actions, QWidget* parent)
    : QWidget(parent), session_(session), feed_(session) {
  setObjectName(QStringLiteral("timeline"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  transport_ = new Transport(session_, actions, this);
  bar_ = new TimeBar(session_, axis_, feed_, actions, this);
  column->addWidget(transport_);
  column->addWidget(bar_);
  column->addStretch(1);
  connect(&session_.document(), &Document::sceneChanged, this, &Timeline::fitAxis);
  connect(&feed_, &NoteFeed::reset, this, &Timeline::fitAxis);
  connect(&feed_, &NoteFeed::grown, this, &Timeline::fitAxis);
  fitAxis();
}

void Timeline::fitAxis() {
  const double recorded = feed_.notes().empty() ? 0.0 : feed_.notes().back().time;
  axis_.setEnd(std::max(session_.document().scene().output.duration, recorded));
}

}  // namespace ui
