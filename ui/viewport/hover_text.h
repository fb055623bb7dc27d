#pragma once

#include <QString>
#include <memory>

#include "ui/viewport/draw_data.h"
#include "ui/viewport/pick.h"

namespace modeling {
struct Scene;
}

namespace ui {

class BreakHistory;
class Footage;

/// What lies under the pointer, in the words of the person; empty where nothing does. `data` is what was
/// picked from. When a broken bond broke is looked up in the footage that is shown.
QString hoverText(const Pick& pick, const DrawData& data, const modeling::Scene& scene, BreakHistory& breaks,
                  const std::shared_ptr<Footage>& footage);

}  // namespace ui
