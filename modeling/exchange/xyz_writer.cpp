#include <cassert>

#include "modeling/exchange/export.h"
#include "modeling/exchange/text_output.h"

namespace modeling {

namespace {

std::vector<std::string> speciesNames(const sim::Network& network) {
  std::vector<std::string> names;
  for (const sim::Material& material : network.materials) names.push_back(oneWord(material.name, "X"));
  return names;
}

void writeFrame(const sim::Network& network, const std::vector<std::string>& species,
                const sim::Snapshot& frame, TextOutput& out) {
  out << static_cast<std::uint64_t>(network.nodeCount()) << "\n"
      << "Properties=species:S:1:pos:R:3:velo:R:3:fragment:I:1 Time=" << frame.time
      << " Step=" << frame.stepCount << "\n";
  for (std::size_t node = 0; node < network.nodeCount(); ++node) {
    out << species[network.nodeMaterials[node]] << " " << frame.positions[node] << " "
        << frame.velocities[node] << " " << static_cast<std::uint64_t>(frame.fragmentOfNode[node]) << "\n";
  }
}

}  // namespace

sim::Status writeXyz(const sim::TakeReader& take, const ExportRequest& request) {
  assert(request.firstFrame <= request.lastFrame && request.lastFrame < take.frameCount());
  const std::vector<std::string> species = speciesNames(take.network());
  TextOutput out(request.path);
  for (std::size_t index = request.firstFrame; index <= request.lastFrame && out.good(); ++index) {
    const auto frame = take.frame(index);
    if (!frame) return frame.problem();
    writeFrame(take.network(), species, **frame, out);
    const double count = static_cast<double>(request.lastFrame - request.firstFrame + 1);
    if (request.progress && !request.progress(static_cast<double>(index - request.firstFrame + 1) / count)) {
      return sim::Problem{request.path.string(), "the export was cancelled", ""};
    }
  }
  return out.finish();
}

}  // namespace modeling
