#include "app/cli/loose_nodes.h"

#include <array>
#include <utility>

namespace app {
namespace {

/// The first stands for an absent option.
constexpr std::array<std::pair<const char*, sim::LooseNodes>, 4> kLooseNodes{
    {{"shards", sim::LooseNodes::shards},
     {"tetrahedra", sim::LooseNodes::tetrahedra},
     {"spheres", sim::LooseNodes::spheres},
     {"given-to-neighbours", sim::LooseNodes::givenToNeighbours}}};

}  // namespace

Option looseNodesOption(std::string& name) {
  Option option{.name = "--loose-nodes",
                .target = &name,
                .help =
                    "How nodes are shown that nothing holds any more: shards that fill what their cells "
                    "filled, tetrahedra, spheres, or not at all, their material given to the fragments "
                    "beside them",
                .shownDefault = kLooseNodes.front().first};
  for (const auto& [one, value] : kLooseNodes) option.oneOf.emplace_back(one);
  return option;
}

sim::LooseNodes looseNodesNamed(const std::string& name) {
  for (const auto& [one, value] : kLooseNodes) {
    if (name == one) return value;
  }
  return kLooseNodes.front().second;
}

}  // namespace app
