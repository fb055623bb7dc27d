#pragma once

#include <vector>

#include "ui/viewport/draw_data.h"
#include "ui/viewport/viewport_renderer.h"

namespace ui {

/// What a thing of the picture is to the person, as the view shows it.
Pick resolved(const PickedThing& thing, const DrawData& data, const modeling::Scene& document);

/// The part or collider of the document by that name.
std::optional<Item> itemNamed(const modeling::Scene& document, ItemKind kind, const std::string& name);

}  // namespace ui
