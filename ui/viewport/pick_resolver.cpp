#include "ui/viewport/pick_resolver.h"

#include <limits>

namespace ui {
namespace {

sim::Vec3 drawnAt(const DrawData& data, sim::NodeIndex node) {
  return Eigen::Map<const Eigen::Vector3f>(data.motion->positions[node].data()).cast<double>();
}

template <class Nodes>
sim::NodeIndex nearest(const DrawData& data, const Nodes& nodes, const sim::Vec3& point) {
  sim::NodeIndex best = sim::kNone;
  double least = std::numeric_limits<double>::infinity();
  for (const sim::NodeIndex node : nodes) {
    const double squared = (drawnAt(data, node) - point).squaredNorm();
    if (squared >= least) continue;
    least = squared;
    best = node;
  }
  return best;
}

/// Of all nodes: for the level surface, which belongs to none.
sim::NodeIndex nearestOfAll(const DrawData& data, const sim::Vec3& point) {
  std::vector<sim::NodeIndex> nodes(data.motion->positions.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = static_cast<sim::NodeIndex>(i);
  return nearest(data, nodes, point);
}

void addNode(sim::NodeIndex node, const DrawData& data, const modeling::Scene& document, Pick& pick) {
  const sim::Network& network = *data.shown.network;
  pick.node = node;
  const sim::PartIndex part = network.nodeParts[node];
  if (part < network.partNames.size())
    pick.item = itemNamed(document, ItemKind::part, network.partNames[part]);
}

/// A face stands for its part, its fragment or its cell, as the colours tell them apart.
void resolveFace(const PickedThing& thing, const DrawData& data, const modeling::Scene& document,
                 Pick& pick) {
  const DrawnFace& face = data.topology->faces[thing.index];
  const sim::Network& network = *data.shown.network;
  pick.node = nearest(data, face.nodes, thing.point);
  if (face.part < network.partNames.size())
    pick.item = itemNamed(document, ItemKind::part, network.partNames[face.part]);
  pick.kind = Pick::Kind::part;
  pick.index = pick.item ? static_cast<std::uint32_t>(pick.item->index) : face.part;
  if (data.settings.colouring == Colouring::fragments) {
    pick.kind = Pick::Kind::fragment;
    pick.index = face.fragment;
  } else if (data.settings.colouring == Colouring::quality) {
    pick.kind = Pick::Kind::cell;
    pick.index = face.cell;
  }
}

}  // namespace

std::optional<Item> itemNamed(const modeling::Scene& document, ItemKind kind, const std::string& name) {
  const auto search = [&](const auto& list) -> std::optional<Item> {
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list[i].name == name) return Item{kind, i};
    }
    return std::nullopt;
  };
  return kind == ItemKind::collider ? search(document.environment.colliders) : search(document.parts);
}

Pick resolved(const PickedThing& thing, const DrawData& data, const modeling::Scene& document) {
  Pick pick;
  pick.kind = thing.kind;
  pick.index = thing.index;
  pick.point = thing.point;
  pick.normal = thing.normal;
  switch (thing.kind) {
    case Pick::Kind::part:
      if (thing.shard) {
        pick.kind = Pick::Kind::node;
        pick.index = data.topology->shards[3 * std::size_t{thing.index}].node;
        addNode(pick.index, data, document, pick);
      } else if (thing.index == sim::kNone) {
        addNode(nearestOfAll(data, thing.point), data, document, pick);
        pick.index = pick.item ? static_cast<std::uint32_t>(pick.item->index) : 0;
      } else {
        resolveFace(thing, data, document, pick);
      }
      break;
    case Pick::Kind::node:
      addNode(thing.index, data, document, pick);
      break;
    case Pick::Kind::bond: {
      const LatticeDraw::Bond& bond = data.lattice->bonds[thing.index];
      addNode(nearest(data, std::array{bond.a, bond.b}, thing.point), data, document, pick);
      break;
    }
    case Pick::Kind::collider:
      pick.item = itemNamed(document, ItemKind::collider, data.colliders[thing.index].name);
      if (pick.item) pick.index = static_cast<std::uint32_t>(pick.item->index);
      break;
    default:
      break;
  }
  return pick;
}

}  // namespace ui
