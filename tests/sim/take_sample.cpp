#include "tests/sim/take_sample.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>

#include "sim/take/frame_codec.h"

namespace tests {
namespace {

std::size_t brokenAt(std::size_t frame) {
  return (frame + 2) / 3;
}

bool sameBytes(const sim::ByteWriter& a, const sim::ByteWriter& b) {
  return std::equal(a.bytes().begin(), a.bytes().end(), b.bytes().begin(), b.bytes().end());
}

void addFragments(const sim::Network& network, std::size_t number, sim::Snapshot& frame,
                  sim::Broken& broken) {
  const std::size_t count = std::min(1 + brokenAt(number) / 2, network.nodeCount());
  for (std::size_t f = 0; f < count; ++f) {
    sim::Fragment fragment;
    fragment.id = static_cast<sim::FragmentId>(f == 0 ? 0 : 10 + f);
    fragment.parent = f == 0 ? sim::kNone : 0;
    fragment.born = 0.01 * static_cast<double>(f);
    fragment.nodeCount = f == 0 ? static_cast<std::uint32_t>(network.nodeCount() - count + 1) : 1;
    fragment.mass = fragment.nodeCount;
    sim::MovingFragment moving;
    moving.id = fragment.id;
    moving.centre = frame.positions[f];
    moving.velocity = frame.velocities[f];
    moving.boxMin = moving.centre - sim::Vec3(0.5, 0.25, 1.0 / 3.0);
    moving.boxMax = moving.centre + sim::Vec3(0.5, 0.25, 1.0 / 3.0);
    broken.fragments.push_back(fragment);
    frame.fragments.push_back(moving);
    if (f > 0) broken.fragmentOfNode[f - 1] = fragment.id;
  }
}

}  // namespace

sim::TakeHeader sampleHeader() {
  return {.scene = "{\"name\": \"block\"}\n", .sceneHash = "0123abcd", .framesPerSecond = 240.0, .seed = 7};
}

sim::Snapshot sampleFrame(const sim::Network& network, std::size_t number) {
  std::mt19937_64 random(number);
  std::normal_distribution<double> shake(0.0, 1e-3);
  const double time = static_cast<double>(number) / 240.0;
  sim::Snapshot frame;
  frame.time = time;
  frame.stepCount = 17 * number;
  for (const sim::Vec3& position : network.positions) {
    frame.positions.push_back(position +
                              sim::Vec3(shake(random), shake(random), shake(random) - 490.5 * time * time));
    frame.velocities.push_back(sim::Vec3(shake(random), shake(random), shake(random) - 981.0 * time));
  }
  sim::Broken broken;
  broken.fragmentOfNode.assign(network.nodeCount(), 0);
  broken.bonds.assign(network.bondCount(), 0);
  broken.cells.assign(network.cellCount(), 0);
  for (std::size_t b = 0; b < brokenAt(number); ++b) {
    broken.bonds[7 * b % network.bondCount()] = 1;
    broken.cells[b % network.cellCount()] = 1;
  }
  addFragments(network, number, frame, broken);
  frame.broken = sim::sealed(std::move(broken));
  frame.ledger.time = time;
  frame.ledger.energy = {1.0 + time, 2.0 / 3.0, -time, 0.1, 0.2, 0.3, 0.4, 1e-17};
  frame.ledger.linearMomentum = sim::Vec3(0.0, -0.0, -981.0 * time);
  frame.ledger.angularMomentum = sim::Vec3(1e-300, 5e-324, std::sqrt(2.0));
  frame.ledger.step = 1e-5;
  return frame;
}

std::vector<sim::BreakEvent> sampleEvents(const sim::Network& network, std::size_t number) {
  if (number == 0 || brokenAt(number) == brokenAt(number - 1)) return {};
  const auto bond = static_cast<sim::BondIndex>(7 * (brokenAt(number) - 1) % network.bondCount());
  sim::BreakEvent event;
  event.time = (static_cast<double>(number) - 0.5) / 240.0;
  event.bond = bond;
  event.a = network.bondStart(bond);
  event.b = network.bondEnds[bond];
  event.strain = 0.001F * static_cast<float>(number);
  event.cell = number % 2 == 0 ? sim::kNone : 0;
  return {event};
}

std::vector<std::byte> sampleCheckpoint(std::size_t number) {
  std::mt19937 random(static_cast<unsigned>(number));
  std::vector<std::byte> bytes(500 + number);
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
  return bytes;
}

sim::Status appendSample(sim::TakeWriter& writer, const sim::Network& network, std::size_t first,
                         std::size_t last) {
  for (std::size_t number = first; number < last; ++number) {
    const auto appended = writer.appendFrame(sampleFrame(network, number), sampleEvents(network, number));
    if (!appended) return appended;
    if (number % kFramesPerCheckpoint != 0) continue;
    if (const auto checkpointed = writer.appendCheckpoint(sampleCheckpoint(number)); !checkpointed)
      return checkpointed;
  }
  return sim::Done{};
}

bool identical(const sim::Snapshot& a, const sim::Snapshot& b) {
  return sameBytes(sim::encodeFrame(a), sim::encodeFrame(b)) &&
         sameBytes(sim::encodeBreakage(*a.broken), sim::encodeBreakage(*b.broken)) &&
         a.broken->version == b.broken->version;
}

bool identical(const std::vector<sim::BreakEvent>& a, const std::vector<sim::BreakEvent>& b) {
  return sameBytes(sim::encodeEvents(a), sim::encodeEvents(b));
}

std::vector<char> fileBytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void writeBytes(const std::filesystem::path& path, const std::vector<char>& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

ScratchFolder::ScratchFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "take-XXXXXX").string();
  path_ = ::mkdtemp(pattern.data());
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace tests
