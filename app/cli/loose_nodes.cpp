#include "app/cli/loose_nodes.h"

#include <map>
#include <string>

namespace app {

CLI::Option* addLooseNodes(CLI::App& command, sim::LooseNodes& looseNodes) {
  static const std::map<std::string, sim::LooseNodes> kLooseNodes{
      {"shards", sim::LooseNodes::shards},
      {"tetrahedra", sim::LooseNodes::tetrahedra},
      {"spheres", sim::LooseNodes::spheres},
      {"given-to-neighbours", sim::LooseNodes::givenToNeighbours}};
  return command
      .add_option(
          "--loose-nodes", looseNodes,
          "How nodes are shown that nothing holds any more: shards that fill what their cells filled, "
          "tetrahedra, spheres, or not at all, their material given to the fragments beside them")
      ->transform(CLI::CheckedTransformer(kLooseNodes))
      ->default_str("shards");
}

}  // namespace app
