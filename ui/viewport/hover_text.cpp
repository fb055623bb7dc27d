#include "ui/viewport/break_history.h"
#include "ui/viewport/viewport.h"

namespace ui {
namespace {

QString nodeText(const DrawData& data, sim::NodeIndex node) {
  const sim::Network& network = *data.shown.network;
  const sim::Snapshot& moment = *data.shown.moment;
  const sim::PartIndex part = network.nodeParts[node];
  QStringList lines{Viewport::tr("<b>Node %1</b>").arg(node)};
  if (part < network.partNames.size())
    lines << Viewport::tr("of %1").arg(QString::fromStdString(network.partNames[part]).toHtmlEscaped());
  const double mass = network.masses[node];
  lines << (std::isfinite(mass) ? Viewport::tr("mass %1 g").arg(mass, 0, 'g', 4) : Viewport::tr("held"));
  lines << Viewport::tr("speed %1 cm/s").arg(moment.velocities[node].norm(), 0, 'g', 4);
  return lines.join("<br>");
}

QString percent(double share) {
  return Viewport::tr("%1 %").arg(100.0 * share, 0, 'g', 3);
}

QString breakText(const sim::BreakEvent& event) {
  const QString when = Viewport::tr("broke at %1 s").arg(event.time, 0, 'f', 4);
  if (event.cell != sim::kNone) return when + Viewport::tr(", taken along by cell %1").arg(event.cell);
  return when + Viewport::tr(", stretched by %1").arg(percent(static_cast<double>(event.strain)));
}

QString weightText(const DrawData& data, sim::FragmentId id) {
  const sim::Snapshot& moment = *data.shown.moment;
  for (std::size_t i = 0; i < moment.fragments.size(); ++i) {
    const sim::Fragment& fragment = moment.broken->fragments[i];
    if (fragment.id != id) continue;
    return Viewport::tr("<br>%L1 nodes, %2 g<br>speed %3 cm/s")
        .arg(fragment.nodeCount)
        .arg(fragment.mass, 0, 'g', 4)
        .arg(moment.fragments[i].velocity.norm(), 0, 'g', 4);
  }
  return {};
}

QString partText(const DrawData& data, const Pick& pick) {
  const sim::Network& network = *data.shown.network;
  QString name;
  if (pick.node != sim::kNone && network.nodeParts[pick.node] < network.partNames.size())
    name = QString::fromStdString(network.partNames[network.nodeParts[pick.node]]).toHtmlEscaped();
  switch (pick.kind) {
    case Pick::Kind::fragment:
      return Viewport::tr("<b>Fragment %1</b><br>of %2").arg(pick.index).arg(name) +
             weightText(data, pick.index);
    case Pick::Kind::cell:
      return Viewport::tr("<b>Cell %1</b><br>of %2").arg(pick.index).arg(name);
    default:
      return name.isEmpty() ? QString() : Viewport::tr("<b>%1</b><br>part").arg(name);
  }
}

}  // namespace

QString Viewport::describe(const Pick& pick) {
  const modeling::Scene& scene = session_.document().scene();
  switch (pick.kind) {
    case Pick::Kind::nothing:
      return {};
    case Pick::Kind::collider:
      return pick.item ? tr("<b>%1</b><br>collider").arg(nameOf(scene, *pick.item).toHtmlEscaped())
                       : QString();
    case Pick::Kind::node:
      return nodeText(*drawn_, pick.index);
    case Pick::Kind::bond:
      break;
    default:
      return partText(*drawn_, pick);
  }
  const LatticeDraw::Bond& bond = drawn_->lattice->bonds[pick.index];
  const sim::Snapshot& moment = *drawn_->shown.moment;
  const double length = (moment.positions[bond.a] - moment.positions[bond.b]).norm();
  QStringList lines{tr("<b>Bond %1</b>").arg(pick.index), tr("nodes %1 and %2").arg(bond.a).arg(bond.b)};
  const bool breakable = std::isfinite(bond.threshold);
  lines << tr("threshold %1").arg(breakable ? percent(static_cast<double>(bond.threshold)) : tr("none"));
  if ((drawn_->topology->bondFlags[pick.index] & kBondBroken) == 0) {
    lines << tr("strain %1").arg(percent(length / static_cast<double>(bond.restLength) - 1.0));
  } else {
    const std::shared_ptr<Footage>& footage =
        drawn_->shown.live ? session_.run()->footage : session_.playback().footage();
    const auto event = breaks_->of(footage, pick.index);
    lines << (event                  ? breakText(*event)
              : breaks_->isReading() ? tr("broken; looking up when")
                                     : tr("broken"));
  }
  return lines.join("<br>");
}

}  // namespace ui
