#include <algorithm>
#include <array>
#include <cmath>

#include "modeling/exchange/export.h"
#include "modeling/exchange/frame_loop.h"
#include "modeling/text/text_output.h"

namespace modeling {

namespace {

/// Readers of this format take a species for a chemical element and refuse what is none. So each material has
/// an element of its own, which says no more than that it is another one.
constexpr std::array<const char*, 54> kElements{
    "H",  "He", "Li", "Be", "B",  "C",  "N",  "O",  "F",  "Ne", "Na", "Mg", "Al", "Si",
    "P",  "S",  "Cl", "Ar", "K",  "Ca", "Sc", "Ti", "V",  "Cr", "Mn", "Fe", "Co", "Ni",
    "Cu", "Zn", "Ga", "Ge", "As", "Se", "Br", "Kr", "Rb", "Sr", "Y",  "Zr", "Nb", "Mo",
    "Tc", "Ru", "Rh", "Pd", "Ag", "Cd", "In", "Sn", "Sb", "Te", "I",  "Xe"};

/// One word each, in the order of their numbers, without letters that have a meaning in a comment line.
std::string namesOfMaterials(const sim::Network& network) {
  std::string names;
  for (const sim::Material& material : network.materials) {
    std::string name = oneWord(material.name, "unnamed");
    std::replace_if(
        name.begin(), name.end(),
        [](char letter) { return std::string_view("\"'{}[]=,\\").find(letter) != std::string_view::npos; },
        '_');
    names.append(names.empty() ? "" : " ").append(name);
  }
  return names;
}

void writeFrame(const sim::Network& network, const std::string& materials, const sim::Snapshot& frame,
                TextOutput& out) {
  out << static_cast<std::uint64_t>(network.nodeCount()) << "\n"
      << "Properties=species:S:1:pos:R:3:velo:R:3:fragment:I:1:material:I:1:masses:R:1 Time=" << frame.time
      << " Step=" << frame.stepCount << " materials=\"" << materials << "\" pbc=\"F F F\"\n";
  for (std::size_t node = 0; node < network.nodeCount(); ++node) {
    const std::uint64_t material = network.nodeMaterials[node];
    const sim::FragmentId fragment = frame.broken->fragmentOfNode[node];
    out << kElements[material % kElements.size()] << " " << frame.positions[node] << " "
        << frame.velocities[node] << " ";
    if (fragment == sim::kNone)
      out << "-1 ";
    else
      out << std::uint64_t{fragment} << " ";
    out << material << " " << (std::isfinite(network.masses[node]) ? network.masses[node] : 0.0) << "\n";
  }
}

}  // namespace

sim::Status writeXyz(const sim::TakeReader& take, const ExportRequest& request) {
  const std::string materials = namesOfMaterials(take.network());
  TextOutput out(request.path);
  const auto status =
      forEachFrame(take, request, [&](std::size_t, const sim::Snapshot& frame) -> sim::Status {
        writeFrame(take.network(), materials, frame, out);
        return out.good() ? sim::Status(sim::Done{}) : out.finish();
      });
  if (!status) return status;
  return out.finish();
}

}  // namespace modeling
