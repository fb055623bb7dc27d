#pragma once

#include <QString>
#include <string>

#include "modeling/scene/scene.h"

namespace ui {

/// A place in the scene as Problems name it, in the words the window uses: "parts[0].wallThickness" becomes
/// "Part “cup”, wall thickness". Other places, such as files, stay as they are.
QString placeInWords(const modeling::Scene& scene, const std::string& place);

}  // namespace ui
