#pragma once

#include "ui/viewport/view_settings.h"

namespace ui {

/// How the person last looked at things, from one start of the program to the next; what is of one scene
/// only, such as hidden parts, is not kept, and fragments are put together again.
ViewSettings recallView();
void rememberView(const ViewSettings& settings);

}  // namespace ui
