#include "ui/viewport/hover_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <cmath>

#include "ui/viewport/break_history.h"

namespace ui {
namespace {

QString words(const char* text) {
  return QCoreApplication::translate("ui::Viewport", text);
}

QString nodeText(const DrawData& data, sim::NodeIndex node) {
  const sim::Network& network = *data.shown.network;
  const sim::Snapshot& moment = *data.shown.moment;
  const sim::PartIndex part = network.nodeParts[node];
  QStringList lines{words("<b>Node %1</b>").arg(node)};
  if (part < network.partNames.size())
    lines << words("of %1").arg(QString::fromStdString(network.partNames[part]).toHtmlEscaped());
  const double mass = network.masses[node];
  lines << (std::isfinite(mass) ? words("mass %1 g").arg(mass, 0, 'g', 4) : words("held"));
  lines << words("speed %1 cm/s").arg(moment.velocities[node].norm(), 0, 'g', 4);
  return lines.join("<br>");
}

QString percent(double share) {
  return words("%1 %").arg(100.0 * share, 0, 'g', 3);
}

QString breakText(const sim::BreakEvent& event) {
  const QString when = words("broke at %1 s").arg(event.time, 0, 'f', 4);
  if (event.cell != sim::kNone) return when + words(", taken along by cell %1").arg(event.cell);
  return when + words(", stretched by %1").arg(percent(static_cast<double>(event.strain)));
}

QString weightText(const DrawData& data, sim::FragmentId id) {
  const sim::Snapshot& moment = *data.shown.moment;
  for (std::size_t i = 0; i < moment.fragments.size(); ++i) {
    const sim::Fragment& fragment = moment.broken->fragments[i];
    if (fragment.id != id) continue;
    return words("<br>%L1 nodes, %2 g<br>speed %3 cm/s")
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
      return words("<b>Fragment %1</b><br>of %2").arg(pick.index).arg(name) + weightText(data, pick.index);
    case Pick::Kind::cell:
      return words("<b>Cell %1</b><br>of %2").arg(pick.index).arg(name);
    default:
      return name.isEmpty() ? QString() : words("<b>%1</b><br>part").arg(name);
  }
}

QString colliderText(const modeling::Scene& scene, const Pick& pick) {
  if (!pick.item) return {};
  return words("<b>%1</b><br>collider").arg(nameOf(scene, *pick.item).toHtmlEscaped());
}

QString bondText(const DrawData& data, sim::BondIndex index, BreakHistory& breaks,
                 const std::shared_ptr<Footage>& footage) {
  const LatticeDraw::Bond& bond = data.lattice->bonds[index];
  const sim::Snapshot& moment = *data.shown.moment;
  const double length = (moment.positions[bond.a] - moment.positions[bond.b]).norm();
  QStringList lines{words("<b>Bond %1</b>").arg(index), words("nodes %1 and %2").arg(bond.a).arg(bond.b)};
  const bool breakable = std::isfinite(bond.threshold);
  lines
      << words("threshold %1").arg(breakable ? percent(static_cast<double>(bond.threshold)) : words("none"));
  if ((data.topology->bondFlags[index] & kBondBroken) == 0) {
    lines << words("strain %1").arg(percent(length / static_cast<double>(bond.restLength) - 1.0));
  } else {
    const auto event = breaks.of(footage, index);
    lines << (event                ? breakText(*event)
              : breaks.isReading() ? words("broken; looking up when")
                                   : words("broken"));
  }
  return lines.join("<br>");
}

}  // namespace

QString hoverText(const Pick& pick, const DrawData& data, const modeling::Scene& scene, BreakHistory& breaks,
                  const std::shared_ptr<Footage>& footage) {
  switch (pick.kind) {
    case Pick::Kind::nothing:
      return {};
    case Pick::Kind::collider:
      return colliderText(scene, pick);
    case Pick::Kind::node:
      return nodeText(data, pick.index);
    case Pick::Kind::bond:
      return bondText(data, pick.index, breaks, footage);
    case Pick::Kind::part:
    case Pick::Kind::cell:
    case Pick::Kind::fragment:
      return partText(data, pick);
  }
  return {};
}

}  // namespace ui
