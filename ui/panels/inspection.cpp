#include "ui/panels/inspection.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace ui {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("Inspection", text);
}

QString number(double value, const char* unit) {
  return QStringLiteral("%1 %2").arg(QString::number(value, 'g', 4), QLatin1String(unit));
}

QString vectorText(const sim::Vec3& vector, const char* unit) {
  return QStringLiteral("%1  %2  %3 %4")
      .arg(QString::number(vector.x(), 'g', 3), QString::number(vector.y(), 'g', 3),
           QString::number(vector.z(), 'g', 3), QLatin1String(unit));
}

QString percent(double share) {
  // Below, it is how numbers are rounded.
  constexpr double kLeast = 1e-9;
  if (std::abs(share) < kLeast) share = 0.0;
  return number(100.0 * share, "%");
}

QString stateText(sim::FragmentState state) {
  switch (state) {
    case sim::FragmentState::deforming:
      return tr("deforming");
    case sim::FragmentState::rigid:
      return tr("rigid");
    case sim::FragmentState::asleep:
      return tr("asleep");
  }
  return {};
}

QString materialOf(const sim::Network& network, sim::MaterialIndex material) {
  return material < network.materials.size() ? QString::fromStdString(network.materials[material].name)
                                             : QString();
}

void addBreak(Inspection& found, const std::optional<sim::BreakEvent>& event) {
  if (!event) {
    found.facts.push_back({tr("State"), tr("broken")});
    return;
  }
  found.facts.push_back({tr("Broke at"), QStringLiteral("%1 s").arg(event->time, 0, 'f', 5)});
  found.facts.push_back({tr("Strain then"), percent(static_cast<double>(event->strain))});
  found.facts.push_back({tr("Because"), event->cell == sim::kNone
                                            ? tr("it was stretched past its threshold")
                                            : tr("cell %1 broke, whose edge it was").arg(event->cell)});
}

Inspection inspectBond(sim::BondIndex bond, const Shown& shown, const std::optional<sim::BreakEvent>& event) {
  const sim::Network& network = *shown.network;
  const sim::Snapshot& moment = *shown.moment;
  const sim::NodeIndex a = network.bondStart(bond);
  const sim::NodeIndex b = network.bondEnds[bond];
  const sim::BondClass& constants = network.bond(bond);
  const double strain = (moment.positions[a] - moment.positions[b]).norm() / constants.restLength - 1.0;
  const auto threshold = static_cast<double>(network.thresholds[bond]);
  Inspection found;
  found.title = tr("Bond %1").arg(bond);
  found.fragment = moment.broken->fragmentOfNode[a];
  found.facts.push_back({tr("Threshold"), std::isfinite(threshold) ? percent(threshold) : tr("unbreakable")});
  if (moment.broken->hasLostBond(bond)) {
    addBreak(found, event);
  } else {
    found.facts.push_back({tr("Strain"), percent(strain)});
    if (std::isfinite(threshold) && threshold > 0.0) found.strainOfThreshold = strain / threshold;
  }
  found.facts.push_back({tr("Rest length"), number(constants.restLength, "cm")});
  found.facts.push_back({tr("Stiffness"), number(constants.stiffness, "dyn/cm")});
  found.facts.push_back({tr("Material"), materialOf(network, constants.material)});
  found.facts.push_back({tr("Nodes"), QStringLiteral("%1, %2").arg(a).arg(b)});
  return found;
}

Inspection inspectFragment(sim::FragmentId id, const sim::Snapshot& moment) {
  Inspection found;
  const std::vector<sim::Fragment>& fragments = moment.broken->fragments;
  const auto place = std::ranges::find(fragments, id, &sim::Fragment::id);
  found.title = tr("Fragment %1").arg(id);
  found.fragment = id;
  if (place == fragments.end()) {
    found.facts.push_back({tr("State"), tr("not there at this moment")});
    return found;
  }
  const sim::Fragment& fragment = *place;
  const sim::MovingFragment& moving = moment.fragments[static_cast<std::size_t>(place - fragments.begin())];
  found.facts.push_back({tr("State"), stateText(moving.state)});
  found.facts.push_back({tr("Broke off"), fragment.parent == sim::kNone
                                              ? tr("there from the start")
                                              : tr("fragment %1").arg(fragment.parent)});
  if (fragment.parent != sim::kNone)
    found.facts.push_back({tr("Born at"), QStringLiteral("%1 s").arg(fragment.born, 0, 'f', 5)});
  found.facts.push_back({tr("Nodes"), QString::number(fragment.nodeCount)});
  found.facts.push_back({tr("Mass"), number(fragment.mass, "g")});
  found.facts.push_back({tr("Speed"), number(moving.velocity.norm(), "cm/s")});
  found.facts.push_back({tr("Velocity"), vectorText(moving.velocity, "cm/s")});
  found.facts.push_back({tr("Centre"), vectorText(moving.centre, "cm")});
  return found;
}

Inspection inspectNode(sim::NodeIndex node, const Shown& shown) {
  const sim::Network& network = *shown.network;
  const sim::Snapshot& moment = *shown.moment;
  Inspection found;
  found.title = tr("Node %1").arg(node);
  found.fragment = moment.broken->fragmentOfNode[node];
  const double mass = network.masses[node];
  found.facts.push_back({tr("Mass"), std::isfinite(mass) ? number(mass, "g") : tr("held")});
  found.facts.push_back({tr("Position"), vectorText(moment.positions[node], "cm")});
  found.facts.push_back({tr("Speed"), number(moment.velocities[node].norm(), "cm/s")});
  found.facts.push_back({tr("Material"), materialOf(network, network.nodeMaterials[node])});
  found.facts.push_back({tr("Fragment"), QString::number(*found.fragment)});
  return found;
}

Inspection inspectCell(sim::CellIndex cell, const Shown& shown) {
  const sim::CellCorners& corners = shown.network->cells[cell];
  Inspection found;
  found.title = tr("Cell %1").arg(cell);
  found.fragment = shown.moment->broken->fragmentOfNode[corners[0]];
  found.facts.push_back({tr("State"), shown.moment->broken->hasLostCell(cell) ? tr("broken") : tr("whole")});
  found.facts.push_back({tr("Fragment"), QString::number(*found.fragment)});
  found.facts.push_back(
      {tr("Material"), materialOf(*shown.network, shown.network->nodeMaterials[corners[0]])});
  return found;
}

}  // namespace

bool isBroken(const Pick& pick, const Shown& shown) {
  return pick.kind == Pick::Kind::bond && shown.moment && pick.index < shown.moment->broken->bonds.size() &&
         shown.moment->broken->hasLostBond(pick.index);
}

Inspection inspect(const Pick& pick, const Shown& shown, const std::optional<sim::BreakEvent>& event) {
  if (!shown.network || !shown.moment) return {};
  const sim::Network& network = *shown.network;
  const sim::Snapshot& moment = *shown.moment;
  switch (pick.kind) {
    case Pick::Kind::bond:
      return pick.index < network.bondCount() ? inspectBond(pick.index, shown, event) : Inspection();
    case Pick::Kind::node:
      return pick.index < network.nodeCount() ? inspectNode(pick.index, shown) : Inspection();
    case Pick::Kind::cell:
      return pick.index < network.cellCount() ? inspectCell(pick.index, shown) : Inspection();
    case Pick::Kind::fragment:
      return inspectFragment(pick.index, moment);
    case Pick::Kind::part:
      // A part of a running simulation is seen as what it has become.
      return pick.node < network.nodeCount()
                 ? inspectFragment(moment.broken->fragmentOfNode[pick.node], moment)
                 : Inspection();
    case Pick::Kind::collider:
    case Pick::Kind::nothing:
      break;
  }
  return {};
}

}  // namespace ui
