#pragma once

#include <QIcon>

#include "ui/document/selection.h"

namespace ui {

/// A drawing for each kind of thing; a material's is its colour.
QIcon iconOf(const modeling::Scene& scene, const Item& item);
/// A round sample of a material's outside and, in a corner, of its inside.
QIcon swatchOf(const modeling::Look& look);
/// resources/icons/NAME.svg; faint where `quiet`, so that in a list only what is out of the ordinary stands
/// out.
QIcon quietIcon(const char* name, bool quiet);

}  // namespace ui
