#include "modeling/exchange/shape_chunks.h"

#include <algorithm>
#include <utility>

namespace modeling {

namespace {

using Listed = std::vector<std::pair<MaterialSide, const ShapeTriangle*>>;

void addTo(ShapeChunk& chunk, const MaterialSide& side, const ShapeTriangle& triangle) {
  auto& list = chunk.triangles[side];
  list.insert(list.end(), triangle.vertices.begin(), triangle.vertices.end());
}

/// `listed`: all triangles that are seen in any of these shapes, and of others those that reach beyond.
void divide(std::size_t first, std::size_t last, const Listed& listed, std::vector<ShapeChunk>& chunks) {
  ShapeChunk common{first, last, {}};
  const std::size_t middle = first + (last - first) / 2;
  Listed early, late;
  for (const auto& [side, triangle] : listed) {
    if (triangle->firstShape <= first && triangle->lastShape >= last) {
      addTo(common, side, *triangle);
      continue;
    }
    if (triangle->firstShape <= middle && triangle->lastShape >= first) early.emplace_back(side, triangle);
    if (triangle->firstShape <= last && triangle->lastShape > middle) late.emplace_back(side, triangle);
  }
  if (!common.triangles.empty()) chunks.push_back(std::move(common));
  if (!early.empty()) divide(first, middle, early, chunks);
  if (!late.empty()) divide(middle + 1, last, late, chunks);
}

}  // namespace

std::vector<ShapeChunk> shapeChunks(const ShapedFragment& fragment) {
  std::vector<ShapeChunk> chunks(1);
  Listed later;
  for (const auto& [side, triangles] : fragment.triangles()) {
    for (const ShapeTriangle& triangle : triangles) {
      if (triangle.firstShape == 0) addTo(chunks.front(), side, triangle);
      if (triangle.lastShape > 0) later.emplace_back(side, &triangle);
    }
  }
  if (!later.empty()) divide(1, fragment.shapes().size() - 1, later, chunks);
  return chunks;
}

}  // namespace modeling
