#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include "modeling/exchange/lammps_model.h"
#include "modeling/text/text_output.h"

namespace modeling {

namespace {

void writeHeader(const LammpsModel& model, std::uint64_t bonds, TextOutput& out) {
  const std::vector<Vec3>& positions = model.moment->positions;
  Vec3 low = positions.front();
  Vec3 high = low;
  for (const Vec3& position : positions) {
    low = low.cwiseMin(position);
    high = high.cwiseMax(position);
  }
  out << "Smithereens, lengths by 1/" << model.unitsPerCm << " cm, g, s; time " << model.moment->time
      << " s\n\n"
      << std::uint64_t{positions.size()} << " atoms\n"
      << bonds << " bonds\n"
      << std::uint64_t{model.atomTypes.size()} << " atom types\n"
      << std::uint64_t{model.bondTypes.size() + model.breakLengths.size()} << " bond types\n\n";
  const double margin = model.longestBond + 1e-3 * (high - low).norm();
  const char* const names[] = {" xlo xhi\n", " ylo yhi\n", " zlo zhi\n"};
  low = model.unitsPerCm * (low - Vec3::Constant(margin));
  high = model.unitsPerCm * (high + Vec3::Constant(margin));
  for (int axis = 0; axis < 3; ++axis) out << low[axis] << " " << high[axis] << names[axis];
}

/// The mass of a sphere is given by its density. Held nodes weigh 1 g: nothing moves them.
void writeAtoms(const LammpsModel& model, TextOutput& out) {
  const sim::Network& network = *model.network;
  out << "\nAtoms # hybrid\n\n";
  for (std::size_t node = 0; node < network.nodeCount(); ++node) {
    const double diameter = model.unitsPerCm * std::max(static_cast<double>(network.radii[node]), 1e-6);
    const double mass = std::isfinite(network.masses[node]) ? network.masses[node] : 1.0;
    const double density = mass / (std::numbers::pi / 6.0 * diameter * diameter * diameter);
    out << std::uint64_t{node + 1} << " " << std::uint64_t{model.typeOfNode[node] + 1U} << " "
        << Vec3(model.unitsPerCm * model.moment->positions[node]) << " "
        << std::uint64_t{model.moment->broken->fragmentOfNode[node]} + 1U << " " << diameter << " " << density
        << "\n";
  }
  out << "\nVelocities\n\n";
  for (std::size_t node = 0; node < network.nodeCount(); ++node)
    out << std::uint64_t{node + 1} << " " << Vec3(model.unitsPerCm * model.moment->velocities[node])
        << " 0 0 0\n";
}

/// How many there are: two of each bond that may break.
std::uint64_t bondLines(const LammpsModel& model) {
  std::uint64_t count = 0;
  for (sim::BondIndex bond = 0; bond < model.network->bondCount(); ++bond) {
    if (model.bondIsWhole(bond)) count += model.breakOfBond[bond] != sim::kNone ? 2 : 1;
  }
  return count;
}

void writeBonds(const LammpsModel& model, TextOutput& out) {
  const sim::Network& network = *model.network;
  out << "\nBonds\n\n";
  std::uint64_t id = 0;
  for (sim::NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (sim::BondIndex bond = network.firstBond[a]; bond < network.firstBond[a + 1]; ++bond) {
      if (!model.bondIsWhole(bond)) continue;
      const auto line = [&](std::uint64_t type) {
        out << ++id << " " << type + 1U << " " << std::uint64_t{a + 1U} << " "
            << std::uint64_t{network.bondEnds[bond] + 1U} << "\n";
      };
      line(model.typeOfBond[bond]);
      if (model.breakOfBond[bond] != sim::kNone) line(model.bondTypes.size() + model.breakOfBond[bond]);
    }
  }
}

void writeConstants(const LammpsModel& model, TextOutput& out) {
  const sim::Network& network = *model.network;
  out << "\nConstants\n\n";
  for (std::size_t node = 0; node < network.nodeCount(); ++node)
    out << std::uint64_t{node + 1} << " "
        << model.contactStiffness[node] * model.conditions.settings.contact.stiffnessScale << " "
        << model.dampingTime[node] << "\n";
}

}  // namespace

sim::Status writeLammps(const sim::TakeReader& take, const ExportRequest& request) {
  const std::string name = request.path.stem().string();
  const auto plain = [](unsigned char letter) {
    return std::isalnum(letter) != 0 || letter == '-' || letter == '_' || letter == '.';
  };
  if (name.empty() || !std::all_of(name.begin(), name.end(), plain)) {
    return sim::Problem{request.path.string(), "LAMMPS takes such a name apart",
                        "use letters, digits, \"-\", \"_\" and \".\" only"};
  }
  const auto model = lammpsModel(take, request);
  if (!model) return model.problem();
  const std::uint64_t bonds = bondLines(*model);
  if (bonds == 0)
    return sim::Problem{request.path.string(), "no bond is whole: there is nothing for LAMMPS to do", ""};
  std::filesystem::path data = request.path;
  std::filesystem::path script = request.path;
  TextOutput out(data.replace_extension(".data"));
  writeHeader(*model, bonds, out);
  writeAtoms(*model, out);
  writeBonds(*model, out);
  writeConstants(*model, out);
  if (auto status = out.finish(); !status) return status;
  TextOutput input(script.replace_extension(".in"));
  input << lammpsScript(*model, name);
  if (auto status = input.finish(); !status) return status;
  if (request.remark) {
    for (const std::string& said : lammpsDeviations(*model)) request.remark(said);
  }
  if (request.progress) request.progress(1.0);
  return sim::Done{};
}

}  // namespace modeling
