#pragma once

#include <map>
#include <vector>

#include "modeling/exchange/fragment_shapes.h"

namespace modeling {

/// Triangles that some consecutive shapes of a fragment have in common.
struct ShapeChunk {
  std::size_t firstShape = 0;
  std::size_t lastShape = 0;
  std::map<MaterialSide, std::vector<std::uint32_t>> triangles;  ///< three vertices of the fragment each
};

/// Shares the shapes of a fragment out into chunks, so that a body which loses something in every frame is
/// not written as often as it has shapes. Each shape is the union of the chunks that it is among: of n shapes
/// each has at most 2 + log2 n, and a triangle is in at most 1 + 2 log2 n of them (a segment tree, Bentley
/// 1977). The first shape is one chunk of its own.
std::vector<ShapeChunk> shapeChunks(const ShapedFragment& fragment);

}  // namespace modeling
