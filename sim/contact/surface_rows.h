#pragma once

#include <vector>

#include "sim/base/bytes.h"
#include "sim/contact/outside.h"
#include "sim/contact/surface_contact.h"

namespace sim {

/// A node, or a sharp edge, and all of other surfaces that is near it.
struct SurfaceRow {
  std::uint32_t which = 0;  ///< the node, or the edge
  bool isEdge = false;
  std::uint32_t first = 0, last = 0;  ///< of SurfaceRows::near: triangles for a node, edges for an edge
};

/// Which surfaces may touch where, until something has moved by a skin's width, and where they do.
struct SurfaceRows {
  std::vector<SurfaceRow> rows;
  std::vector<std::uint32_t> near;
  std::vector<double> clearUntil;           ///< by row: cm of the odometer; till then nothing in it is near
  std::vector<double> farUntil;             ///< by `near` of nodes' rows: the same, of that triangle alone
  std::vector<SurfaceContact> contacts;     ///< by row
  std::vector<std::uint32_t> firstContact;  ///< by row, and one more

  bool quiet() const { return rows.empty(); }

  void save(ByteWriter& writer) const;
  /// False where the bytes cannot have come from save() beside such an outside.
  bool load(const Outside& outside, ByteReader& reader);
  std::size_t memoryBytes() const;
  /// Finds `firstContact`, contacts being by row.
  void index();
};

}  // namespace sim
