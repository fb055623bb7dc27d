#include "sim/contact/surface_rows.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {

void save(const SurfaceContact& contact, ByteWriter& writer) {
  for (const NodeIndex node : contact.nodes) writer.put(node);
  writer.put(contact.row);
  writer.put(contact.corners);
  writer.put(contact.anchored);
  writer.put(contact.inside);
  for (const double number : {contact.sign, contact.natural, contact.rho, contact.stiffness, contact.damping})
    writer.put(number);
  for (const double weight : contact.anchor) writer.put(weight);
}

SurfaceContact loadContact(ByteReader& reader) {
  SurfaceContact contact;
  for (NodeIndex& node : contact.nodes) reader.read(node);
  reader.read(contact.row);
  reader.read(contact.corners);
  reader.read(contact.anchored);
  reader.read(contact.inside);
  for (double* number : {&contact.sign, &contact.natural, &contact.rho, &contact.stiffness, &contact.damping})
    reader.read(*number);
  for (double& weight : contact.anchor) reader.read(weight);
  return contact;
}

bool isProper(const SurfaceContact& contact, std::size_t nodes, std::size_t rows) {
  const bool knownCorners = contact.corners >= 1 && contact.corners <= SurfaceContact::kCrossing;
  return contact.row < rows && knownCorners && std::isfinite(contact.rho) &&
         std::isfinite(contact.stiffness) &&
         std::ranges::all_of(contact.nodes, [&](NodeIndex node) { return node < nodes; });
}

}  // namespace

void SurfaceRows::save(ByteWriter& writer) const {
  writer.put<std::uint64_t>(rows.size());
  for (const SurfaceRow& row : rows) {
    writer.put(row.which);
    writer.put<std::uint8_t>(row.isEdge ? 1 : 0);
    writer.put(row.first);
    writer.put(row.last);
  }
  writer.putVector(near);
  writer.putVector(clearUntil);
  writer.putVector(farUntil);
  writer.put<std::uint64_t>(contacts.size());
  for (const SurfaceContact& contact : contacts) sim::save(contact, writer);
}

bool SurfaceRows::load(const Outside& outside, ByteReader& reader) {
  *this = {};
  const std::size_t nodes = outside.nodeCount();
  std::uint64_t count = 0;
  reader.read(count);
  if (count > reader.remaining()) return reader.fail();
  rows.resize(static_cast<std::size_t>(count));
  for (SurfaceRow& row : rows) {
    std::uint8_t isEdge = 0;
    reader.read(row.which);
    reader.read(isEdge);
    reader.read(row.first);
    reader.read(row.last);
    row.isEdge = isEdge != 0;
  }
  reader.readVector(near);
  reader.readVector(clearUntil);
  reader.readVector(farUntil);
  reader.read(count);
  if (count > reader.remaining()) return reader.fail();
  contacts.resize(static_cast<std::size_t>(count));
  for (SurfaceContact& contact : contacts) contact = loadContact(reader);
  if (!reader.ok() || clearUntil.size() != rows.size() || farUntil.size() != near.size()) return false;
  for (const SurfaceRow& row : rows) {
    const std::size_t features = row.isEdge ? outside.edges().size() : outside.triangles().size();
    if (row.which >= (row.isEdge ? features : nodes) || row.first > row.last || row.last > near.size())
      return false;
    for (std::uint32_t n = row.first; n < row.last; ++n) {
      if (near[n] >= features) return false;
    }
  }
  const auto inOrder = [](const SurfaceContact& left, const SurfaceContact& right) {
    return left.row < right.row;
  };
  if (!std::ranges::is_sorted(contacts, inOrder)) return false;
  for (const SurfaceContact& contact : contacts) {
    if (!isProper(contact, nodes, rows.size())) return false;
  }
  index();
  return true;
}

std::size_t SurfaceRows::memoryBytes() const {
  const auto bytes = [](const auto& vector) { return vector.capacity() * sizeof(vector[0]); };
  return bytes(rows) + bytes(near) + bytes(clearUntil) + bytes(farUntil) + bytes(contacts) +
         bytes(firstContact);
}

void SurfaceRows::index() {
  firstContact.assign(rows.size() + 1, 0);
  for (const SurfaceContact& contact : contacts) ++firstContact[contact.row + 1];
  for (std::size_t r = 0; r < rows.size(); ++r) firstContact[r + 1] += firstContact[r];
}

}  // namespace sim
