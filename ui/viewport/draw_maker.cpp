#include "ui/viewport/draw_maker.h"

#include <algorithm>
#include <chrono>
#include <map>

#include "modeling/exchange/take_scene.h"
#include "modeling/scene/tracks.h"
#include "sim/surface/level_surface.h"
#include "ui/viewport/draw_colours.h"
#include "ui/viewport/topology.h"

namespace ui {
namespace {

/// A million cubes take a few tenths of a second and show the bumps of some ten thousand nodes.
constexpr std::size_t kMostCubes = 1'000'000;

bool isNamed(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::uint8_t> hiddenParts(const sim::Network& network, const ViewSettings& settings) {
  // A network made by hand may name no parts.
  std::vector<std::uint8_t> hidden(std::max<std::size_t>(network.partNames.size(), 1), 0);
  for (std::size_t part = 0; part < network.partNames.size(); ++part)
    hidden[part] = isNamed(settings.hiddenParts, network.partNames[part]) ? 1 : 0;
  return hidden;
}

sim::LooseNodes looseNodesOf(const ViewSettings& settings) {
  return static_cast<sim::LooseNodes>(settings.isolated);
}

LatticeDraw latticeOf(const sim::Network& network) {
  LatticeDraw lattice;
  lattice.bonds.reserve(network.bondCount());
  for (sim::NodeIndex node = 0; node < network.nodeCount(); ++node) {
    for (sim::BondIndex bond = network.firstBond[node]; bond < network.firstBond[node + 1]; ++bond) {
      lattice.bonds.push_back({node, network.bondEnds[bond],
                               static_cast<float>(network.bond(bond).restLength), network.thresholds[bond]});
    }
  }
  return lattice;
}

/// How far each fragment is moved for an exploded view: away from the middle of the body it came from.
std::map<sim::FragmentId, sim::Vec3> explodedOffsets(const sim::Snapshot& moment, double share) {
  std::map<sim::FragmentId, const sim::Fragment*> byId;
  const std::vector<sim::Fragment>& fragments = moment.broken->fragments;
  for (const sim::Fragment& fragment : fragments) byId[fragment.id] = &fragment;
  // A parent that has broken is no living fragment: what came off it counts as of the nearest that is, or
  // else as of the parent's number.
  const auto bodyOf = [&](const sim::Fragment* fragment) {
    for (auto found = byId.find(fragment->parent); found != byId.end(); found = byId.find(fragment->parent))
      fragment = found->second;
    return fragment->parent == sim::kNone ? fragment->id : fragment->parent;
  };
  std::map<sim::FragmentId, std::pair<double, sim::Vec3>> bodies;
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    auto& [mass, moment1] = bodies.try_emplace(bodyOf(&fragments[i]), 0.0, sim::Vec3::Zero()).first->second;
    mass += fragments[i].mass;
    moment1 += fragments[i].mass * moment.fragments[i].centre;
  }
  std::map<sim::FragmentId, sim::Vec3> offsets;
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const auto& [mass, moment1] = bodies.at(bodyOf(&fragments[i]));
    if (mass > 0.0) offsets[fragments[i].id] = share * (moment.fragments[i].centre - moment1 / mass);
  }
  return offsets;
}

std::vector<sim::Vec3> explodedPositions(const sim::Snapshot& moment, double explode) {
  std::vector<sim::Vec3> positions = moment.positions;
  if (explode <= 0.0) return positions;
  const std::map<sim::FragmentId, sim::Vec3> offsets = explodedOffsets(moment, explode);
  const std::vector<sim::FragmentId>& fragmentOfNode = moment.broken->fragmentOfNode;
  sim::FragmentId fragment = sim::kNone;
  sim::Vec3 offset = sim::Vec3::Zero();
  for (std::size_t node = 0; node < positions.size(); ++node) {
    if (fragmentOfNode[node] != fragment) {
      fragment = fragmentOfNode[node];
      const auto found = offsets.find(fragment);
      offset = found == offsets.end() ? sim::Vec3(sim::Vec3::Zero()) : found->second;
    }
    positions[node] += offset;
  }
  return positions;
}

Eigen::AlignedBox3d boxOf(const std::vector<std::array<float, 4>>& positions) {
  Eigen::AlignedBox3f box;
  for (const auto& position : positions) {
    const Eigen::Vector3f point = Eigen::Map<const Eigen::Vector3f>(position.data());
    if (point.allFinite()) box.extend(point);
  }
  return box.cast<double>();
}

LevelDraw drawn(const sim::LevelSurface& surface, const std::vector<std::uint32_t>& colours) {
  LevelDraw draw;
  draw.vertices.reserve(surface.points.size());
  for (std::size_t p = 0; p < surface.points.size(); ++p) {
    const Eigen::Vector3f at = surface.points[p].cast<float>();
    draw.vertices.push_back(
        {{at.x(), at.y(), at.z()}, packNormal(surface.normals[p]), colours[surface.sources[p]]});
  }
  for (const auto& quad : surface.quads) {
    for (const std::size_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) draw.indices.push_back(quad[corner]);
  }
  return draw;
}

}  // namespace

bool DrawMaker::isNewTopology(const DrawData& data, const std::vector<std::uint8_t>& hidden) const {
  if (!last_.topology || last_.shown.network != data.shown.network || hidden != hidden_ ||
      last_.settings.isolated != data.settings.isolated)
    return true;
  const sim::Snapshot& before = *last_.shown.moment;
  const sim::Snapshot& now = *data.shown.moment;
  return before.broken->version != now.broken->version;
}

void DrawMaker::addColours(DrawData& data, bool newTopology) {
  static const modeling::Scene kNoScene;
  const modeling::Scene& scene = data.shown.scene ? *data.shown.scene : kNoScene;
  const Palette palette(*data.shown.network, *data.shown.moment, scene, data.settings);
  std::vector<modeling::Look> looks = modeling::looksOf(scene, *data.shown.network);
  const bool recoloured = newTopology || looks != looks_ ||
                          data.settings.colouring != last_.settings.colouring ||
                          data.settings.insideColour != last_.settings.insideColour;
  const bool otherBalls = recoloured || data.settings.nodes != last_.settings.nodes;
  looks_ = std::move(looks);
  data.colours =
      recoloured ? std::make_shared<const ColourDraw>(palette.surface(*data.topology)) : last_.colours;
  data.nodes = otherBalls ? std::make_shared<const NodeDraw>(palette.nodes(hidden_)) : last_.nodes;
}

void DrawMaker::addMotion(DrawData& data, bool newTopology) {
  if (!newTopology && data.shown.moment == last_.shown.moment &&
      data.settings.explode == last_.settings.explode) {
    data.motion = last_.motion;
    data.box = last_.box;
    return;
  }
  MotionDraw motion;
  motion.positions =
      cornerPositions(*data.topology, explodedPositions(*data.shown.moment, data.settings.explode));
  motion.normals = cornerNormals(*data.topology, motion.positions);
  data.box = boxOf(motion.positions);
  data.motion = std::make_shared<const MotionDraw>(std::move(motion));
}

void DrawMaker::addLevel(DrawData& data, const std::function<bool()>& cancelled) {
  if (!data.settings.levelSurface) return;
  if (last_.level && data.motion == last_.motion && data.colours == last_.colours) {
    data.level = last_.level;
    return;
  }
  static const modeling::Scene kNoScene;
  const Palette palette(*data.shown.network, *data.shown.moment,
                        data.shown.scene ? *data.shown.scene : kNoScene, data.settings);
  const sim::Network& network = *data.shown.network;
  std::vector<sim::FieldSource> sources;
  std::vector<std::uint32_t> colours;
  for (sim::NodeIndex node = 0; node < network.nodeCount(); ++node) {
    if (hidden_[network.nodeParts[node]] != 0) continue;
    const auto& at = data.motion->positions[node];
    const sim::Vec3 position = Eigen::Map<const Eigen::Vector3f>(at.data()).cast<double>();
    if (!position.allFinite()) continue;
    sources.push_back({position, sim::potentialReach(network, node)});
    colours.push_back(palette.ofNode(node));
  }
  const sim::LevelSurface surface = sim::levelSurface(sources, {.mostCubes = kMostCubes}, cancelled);
  if (!cancelled()) data.level = std::make_shared<const LevelDraw>(drawn(surface, colours));
}

DrawData DrawMaker::make(const Shown& shown, const ViewSettings& settings,
                         const std::function<bool()>& cancelled) {
  const auto start = std::chrono::steady_clock::now();
  DrawData data;
  data.shown = shown;
  data.settings = settings;
  if (shown.scene) {
    data.colliders = modeling::collidersAt(*shown.scene, shown.moment ? shown.moment->time : 0.0);
    std::erase_if(data.colliders, [&](const sim::Collider& collider) {
      return isNamed(settings.hiddenColliders, collider.name);
    });
  }
  if (shown.network && shown.moment) {
    if (shown.network != network_ || settings.isolated != last_.settings.isolated)
      surface_ = std::make_unique<sim::SurfaceBuilder>(*shown.network, looseNodesOf(settings));
    if (shown.network != network_) {
      network_ = shown.network;
      data.lattice = std::make_shared<const LatticeDraw>(latticeOf(*network_));
    } else {
      data.lattice =
          last_.lattice ? last_.lattice : std::make_shared<const LatticeDraw>(latticeOf(*network_));
    }
    const std::vector<std::uint8_t> hidden = hiddenParts(*network_, settings);
    const bool newTopology = isNewTopology(data, hidden);
    hidden_ = hidden;
    data.topology = newTopology ? std::make_shared<const TopologyDraw>(
                                      topologyOf(*network_, *surface_, shown.moment->broken, hidden_))
                                : last_.topology;
    addColours(data, newTopology);
    addMotion(data, newTopology);
    addLevel(data, cancelled);
  }
  data.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  last_ = data;
  return data;
}

}  // namespace ui
