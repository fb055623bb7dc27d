#include "app/bench/lammps.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <memory>
#include <string>

#include "app/bench/scratch_folder.h"

namespace app {
namespace {

void writeData(const sim::Network& network, std::ofstream file) {
  sim::Vec3 low = network.positions.front();
  sim::Vec3 high = low;
  for (const sim::Vec3& position : network.positions) {
    low = low.cwiseMin(position);
    high = high.cwiseMax(position);
  }
  file << std::setprecision(17) << "bench\n\n"
       << network.nodeCount() << " atoms\n"
       << network.bondCount() << " bonds\n1 atom types\n"
       << network.classes.size() << " bond types\n\n";
  for (Eigen::Index k = 0; k < 3; ++k) {
    const char axis = "xyz"[k];
    file << low[k] - 1.0 << ' ' << high[k] + 1.0 << ' ' << axis << "lo " << axis << "hi\n";
  }
  // All as heavy as a node inside: with the mass of a corner, an eighth, the step would be unstable.
  const double mass = *std::max_element(network.masses.begin(), network.masses.end());
  file << "\nMasses\n\n1 " << mass << "\n\nAtoms\n\n";
  for (std::size_t n = 0; n < network.nodeCount(); ++n)
    file << n + 1 << " 1 1 " << network.positions[n].transpose() << '\n';
  file << "\nBonds\n\n";
  for (sim::NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (sim::BondIndex b = network.firstBond[a]; b < network.firstBond[a + 1]; ++b)
      file << b + 1 << ' ' << network.bondClasses[b] + 1 << ' ' << a + 1 << ' ' << network.bondEnds[b] + 1
           << '\n';
  }
}

/// LAMMPS writes the energy of a bond K (r - l)^2, so K = k / 2.
void writeInput(const sim::Network& network, double step, int steps, std::ofstream file) {
  double longest = 0.0;
  for (const sim::BondClass& bond : network.classes) longest = std::max(longest, bond.restLength);
  file << std::setprecision(17)
       << "units lj\natom_style bond\nboundary s s s\nread_data bar.data\nbond_style harmonic\n";
  for (std::size_t c = 0; c < network.classes.size(); ++c)
    file << "bond_coeff " << c + 1 << ' ' << 0.5 * network.classes[c].stiffness << ' '
         << network.classes[c].restLength << '\n';
  file << "comm_modify cutoff " << 2.0 * longest << "\nvelocity all create 1.0 1 loop all\nfix 1 all nve\n"
       << "timestep " << step << "\nthermo " << steps << "\nrun " << steps << '\n';
}

std::string outputOf(const std::string& command) {
  std::string output;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  if (!pipe) return output;
  std::array<char, 4096> piece{};
  while (std::fgets(piece.data(), static_cast<int>(piece.size()), pipe.get()) != nullptr)
    output += piece.data();
  return output;
}

/// The number that follows `before` in the text.
std::optional<double> numberAfter(const std::string& text, const std::string& before) {
  const std::size_t place = text.find(before);
  if (place == std::string::npos) return std::nullopt;
  return std::strtod(text.c_str() + place + before.size(), nullptr);
}

}  // namespace

std::optional<double> lammpsBondsPerSecond(const sim::Network& network, double step, int steps) {
  if (outputOf("command -v lmp").empty()) return std::nullopt;
  const ScratchFolder scratch;
  if (scratch.path().empty()) return std::nullopt;
  writeData(network, std::ofstream(scratch.path() / "bar.data"));
  writeInput(network, step, steps, std::ofstream(scratch.path() / "in.bar"));
  const std::string output = outputOf("cd '" + scratch.path().string() +
                                      "' && OMP_NUM_THREADS=1 lmp -in in.bar -log none 2>/dev/null");
  const auto loop = numberAfter(output, "Loop time of ");
  if (!loop || *loop <= 0.0) return std::nullopt;
  // The line after this one begins with the share of the processor it got, in per cent.
  const auto performance = output.find("timesteps/s");
  if (performance == std::string::npos) return std::nullopt;
  const auto lineEnd = output.find('\n', performance);
  const double share = std::strtod(output.c_str() + lineEnd, nullptr) / 100.0;
  if (!(share > 0.0)) return std::nullopt;
  return static_cast<double>(network.bondCount()) * steps / (*loop * share);
}

}  // namespace app
