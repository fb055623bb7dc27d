#include "modeling/exchange/export.h"
#include "modeling/exchange/frame_loop.h"
#include "modeling/text/text_output.h"

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
        << frame.velocities[node] << " " << static_cast<std::uint64_t>(frame.broken->fragmentOfNode[node])
        << "\n";
  }
}

}  // namespace

sim::Status writeXyz(const sim::TakeReader& take, const ExportRequest& request) {
  const std::vector<std::string> species = speciesNames(take.network());
  TextOutput out(request.path);
  const auto status =
      forEachFrame(take, request, [&](std::size_t, const sim::Snapshot& frame) -> sim::Status {
        writeFrame(take.network(), species, frame, out);
        return out.good() ? sim::Status(sim::Done{}) : out.finish();
      });
  if (!status) return status;
  return out.finish();
}

}  // namespace modeling
