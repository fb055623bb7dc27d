#include "ui/viewport/draw_colours.h"

#include "modeling/exchange/take_scene.h"
#include "modeling/shapes/quality.h"
#include "sim/base/random.h"
#include "sim/network/wedge.h"
#include "ui/viewport/colour_map.h"

namespace ui {
namespace {

constexpr std::uint64_t kTintSeed = 0x71f7;
/// Largest loss of brightness of a fragment that came off: shards of one colour would run into one another.
constexpr float kTint = 0.10F;
/// Glaze of colours that stand for something: a bright reflection would be read as a value.
constexpr float kPlainGlaze = 0.1F;
/// Radius of a ball relative to the distance of the nearest neighbour: neighbours stay apart, bonds show.
constexpr float kBall = 0.28F;

float tintOf(sim::FragmentId fragment) {
  return fragment == 0 ? 1.0F : 1.0F - kTint * static_cast<float>(sim::uniformAt(kTintSeed, fragment));
}

}  // namespace

Palette::Palette(const sim::Network& network, const sim::Snapshot& moment, const modeling::Scene& scene,
                 const ViewSettings& settings)
    : network_(network), moment_(moment), settings_(settings), looks_(modeling::looksOf(scene, network)) {}

std::uint32_t Palette::ofMaterial(sim::MaterialIndex material, bool inside, sim::FragmentId fragment) const {
  const modeling::Look look = material < looks_.size() ? looks_[material] : modeling::Look{};
  const bool bared = inside && settings_.insideColour;
  const modeling::Colour& colour = bared ? look.inside : look.outside;
  const float tint = tintOf(fragment);
  return packed({tint * static_cast<float>(colour[0]), tint * static_cast<float>(colour[1]),
                 tint * static_cast<float>(colour[2])},
                bared ? 0.0F : static_cast<float>(look.glaze));
}

std::uint32_t Palette::ofFace(const DrawnFace& face) const {
  switch (settings_.colouring) {
    case Colouring::fragments:
      return packed(fragmentColour(face.fragment), kPlainGlaze);
    case Colouring::quality: {
      const sim::CellCorners& cell = network_.cells[face.cell];
      const modeling::CornerPositions corners = modeling::cornerPositions(network_.positions, cell);
      const double quality =
          sim::isWedge(cell) ? modeling::scaledJacobianOfWedge(corners) : modeling::scaledJacobian(corners);
      return packed(viridis(static_cast<float>(quality)), 0.0F);
    }
    case Colouring::material:
      break;
  }
  return ofMaterial(face.material, face.inside, face.fragment);
}

std::uint32_t Palette::ofNode(sim::NodeIndex node) const {
  if (settings_.colouring == Colouring::fragments)
    return packed(fragmentColour(moment_.broken->fragmentOfNode[node]), kPlainGlaze);
  return ofMaterial(network_.nodeMaterials[node], false, moment_.broken->fragmentOfNode[node]);
}

ColourDraw Palette::surface(const TopologyDraw& topology) const {
  ColourDraw colours;
  colours.corners.reserve(topology.cornerNodes.size());
  for (const DrawnFace& face : topology.faces) colours.corners.insert(colours.corners.end(), 4, ofFace(face));
  colours.shards.reserve(topology.shards.size());
  for (const ShardCorner& corner : topology.shards) {
    const sim::FragmentId fragment = moment_.broken->fragmentOfNode[corner.node];
    colours.shards.push_back(settings_.colouring == Colouring::fragments
                                 ? ofNode(corner.node)
                                 : ofMaterial(network_.nodeMaterials[corner.node], true, fragment));
  }
  return colours;
}

NodeDraw Palette::nodes(const std::vector<std::uint8_t>& hidden) const {
  NodeDraw draw;
  if (!settings_.nodes) return draw;
  draw.balls.reserve(network_.nodeCount());
  for (sim::NodeIndex node = 0; node < network_.nodeCount(); ++node) {
    if (hidden[network_.nodeParts[node]] == 0)
      draw.balls.push_back({node, kBall * network_.radii[node], ofNode(node)});
  }
  return draw;
}

}  // namespace ui
