#include "sim/take/head_codec.h"

#include <cmath>

#include "sim/take/planes.h"

namespace sim {
namespace {

// A member added to one of these must be stored too, and kTakeVersion raised.
static_assert(sizeof(BondClass) == 4 * sizeof(double));
static_assert(sizeof(Material) == sizeof(std::string) + 4 * sizeof(double));
static_assert(sizeof(Network) == sizeof(ClassIndices) + 13 * sizeof(std::vector<int>));
static_assert(sizeof(TakeHeader) == 2 * sizeof(std::string) + 2 * sizeof(double));

/// As many as MaterialIndex and PartIndex can tell apart.
constexpr std::uint64_t kMostNames = 1U << 16;

// Rows are stored as their lengths and ends as distances from the first node: in a lattice both repeat, and
// rows added up from lengths can't overlap whatever the file says.

std::vector<std::uint32_t> rowLengths(const Network& network) {
  std::vector<std::uint32_t> lengths(network.nodeCount());
  for (std::size_t a = 0; a < lengths.size(); ++a) {
    lengths[a] = network.firstBond[a + 1] - network.firstBond[a];
  }
  return lengths;
}

std::vector<std::uint32_t> reaches(const Network& network) {
  std::vector<std::uint32_t> result(network.bondEnds);
  for (std::size_t a = 0; a < network.nodeCount(); ++a) {
    for (BondIndex b = network.firstBond[a]; b < network.firstBond[a + 1]; ++b) {
      result[b] -= static_cast<std::uint32_t>(a);
    }
  }
  return result;
}

/// False when the rows don't cover the bonds exactly.
bool rebuildRows(const std::vector<std::uint32_t>& lengths, Network& network) {
  network.firstBond.assign(1, 0);
  network.firstBond.reserve(lengths.size() + 1);
  std::uint64_t first = 0;
  for (std::size_t a = 0; a < lengths.size(); ++a) {
    const std::uint64_t last = first + lengths[a];
    if (last > network.bondCount()) return false;
    for (; first < last; ++first) network.bondEnds[first] += static_cast<std::uint32_t>(a);
    network.firstBond.push_back(static_cast<BondIndex>(last));
  }
  return first == network.bondCount();
}

void putClasses(ByteWriter& writer, const std::vector<BondClass>& classes) {
  writer.put<std::uint64_t>(classes.size());
  for (const BondClass& bond : classes) {
    writer.put(bond.stiffness);
    writer.put(bond.restLength);
    writer.put(bond.damping);
    writer.put(bond.material);
  }
}

void readClasses(ByteReader& reader, std::vector<BondClass>& classes) {
  std::uint64_t count = 0;
  reader.read(count);
  for (std::uint64_t c = 0; c < count && reader.ok(); ++c) {
    BondClass& bond = classes.emplace_back();
    reader.read(bond.stiffness);
    reader.read(bond.restLength);
    reader.read(bond.damping);
    reader.read(bond.material);
  }
}

void putMaterials(ByteWriter& writer, const std::vector<Material>& materials) {
  writer.put<std::uint64_t>(materials.size());
  for (const Material& material : materials) {
    writer.putString(material.name);
    writer.put(material.thresholdMean);
    writer.put(material.thresholdSpread);
    writer.put(material.yieldStrain);
    writer.put(material.flowRate);
  }
}

void readMaterials(ByteReader& reader, std::vector<Material>& materials) {
  std::uint64_t count = 0;
  reader.read(count);
  if (count > kMostNames) reader.fail();
  for (std::uint64_t m = 0; m < count && reader.ok(); ++m) {
    Material& material = materials.emplace_back();
    reader.readString(material.name);
    reader.read(material.thresholdMean);
    reader.read(material.thresholdSpread);
    reader.read(material.yieldStrain);
    reader.read(material.flowRate);
  }
}

}  // namespace

ByteWriter encodeHead(const TakeHeader& header) {
  ByteWriter writer;
  writer.put(kTakeVersion);
  writer.put(header.framesPerSecond);
  writer.put(header.seed);
  writer.putString(header.sceneHash);
  writer.putString(header.scene);
  return writer;
}

Result<TakeHeader> decodeHead(std::span<const std::byte> content) {
  ByteReader reader(content);
  std::uint32_t version = 0;
  reader.read(version);
  if (reader.ok() && version > kTakeVersion) {
    return Problem{
        "",
        "this take was written by a newer version of the program (layout " + std::to_string(version) + ")",
        "open it with that version"};
  }
  TakeHeader header;
  reader.read(header.framesPerSecond);
  reader.read(header.seed);
  reader.readString(header.sceneHash);
  reader.readString(header.scene);
  const bool proper = version > 0 && std::isfinite(header.framesPerSecond) && header.framesPerSecond > 0.0;
  if (!reader.finished() || !proper) return Problem{"", "the head of the take is damaged", ""};
  return header;
}

ByteWriter encodeNetwork(const Network& network) {
  ByteWriter writer;
  putPlanes(writer, network.positions);
  putPlanes(writer, network.velocities);
  putPlanes(writer, network.masses);
  putPlanes(writer, network.radii);
  putPlanes(writer, network.nodeMaterials);
  putPlanes(writer, network.nodeParts);
  putPlanes(writer, rowLengths(network));
  putPlanes(writer, reaches(network));
  putPlanes(writer, network.bondClasses.inFull());
  putPlanes(writer, network.thresholds);
  putPlanes(writer, network.cells);
  putClasses(writer, network.classes);
  putMaterials(writer, network.materials);
  writer.put<std::uint64_t>(network.partNames.size());
  for (const std::string& name : network.partNames) writer.putString(name);
  return writer;
}

Result<Network> decodeNetwork(std::span<const std::byte> content) {
  ByteReader reader(content);
  Network network;
  std::vector<std::uint32_t> lengths;
  std::vector<std::uint32_t> classes;
  readPlanes(reader, network.positions);
  readPlanes(reader, network.velocities);
  readPlanes(reader, network.masses);
  readPlanes(reader, network.radii);
  readPlanes(reader, network.nodeMaterials);
  readPlanes(reader, network.nodeParts);
  readPlanes(reader, lengths, network.nodeCount());
  readPlanes(reader, network.bondEnds);
  readPlanes(reader, classes);
  network.bondClasses = ClassIndices(classes);
  readPlanes(reader, network.thresholds);
  readPlanes(reader, network.cells);
  readClasses(reader, network.classes);
  readMaterials(reader, network.materials);
  std::uint64_t parts = 0;
  reader.read(parts);
  if (parts > kMostNames) reader.fail();
  for (std::uint64_t p = 0; p < parts && reader.ok(); ++p)
    reader.readString(network.partNames.emplace_back());
  if (!reader.finished() || !rebuildRows(lengths, network)) {
    return Problem{"", "the network in the take is damaged", ""};
  }
  if (const auto fault = network.validate())
    return Problem{"", "the network in the take is damaged: " + *fault, ""};
  return network;
}

}  // namespace sim
