#pragma once

#include "modeling/import/gltf_compression.h"
#include "modeling/import/gltf_document.h"

namespace modeling {

/// The numbers an accessor names, as they are meant: integers that stand for shares are shares, and sparse
/// ones are laid over the others. A Problem where it is not there or damaged.
sim::Result<GltfNumbers> readAccessor(GltfDocument& document, const GltfJson& index);

}  // namespace modeling
