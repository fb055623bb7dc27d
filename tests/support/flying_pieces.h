#pragma once

#include <cstddef>

#include "sim/surface/surface_mesh.h"
#include "tests/support/memory_take.h"

namespace tests {

/// A folded bar of 2 `pieces` - 1 cells of which every second is broken from the second frame on; the
/// `pieces` cubes of 1 cm that are left fly apart and spin, each as a rigid body, but for the first, which
/// lies still. 24 frames a second. A few fragments have parents, all have masses and times of birth.
MemoryTake flyingPieces(std::size_t pieces, std::size_t frames);

/// A straight bar like that, off which one piece more has come in each frame: in frame k the fragments 1 to
/// k, which drift away, and 0, which is what is left.
MemoryTake crumblingBar(std::size_t pieces);

/// The surface of a frame of flyingPieces(), with the last frame's breaks.
sim::SurfaceMesh surfaceOfPieces(const MemoryTake& take, std::size_t frame);

}  // namespace tests
