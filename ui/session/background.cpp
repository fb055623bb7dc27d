#include "ui/session/background.h"

#ifdef __linux__
#include <algorithm>

#include <sys/resource.h>
#endif

namespace ui {

void giveWayToTheWindow() {
#ifdef __linux__
  // A third of the share of a thread that draws, when they compete; all of what is left otherwise.
  constexpr int kNiceness = 5;
  // Of the thread alone: Linux takes a thread for a process here. A refusal changes no result.
  static_cast<void>(setpriority(PRIO_PROCESS, 0, std::max(kNiceness, getpriority(PRIO_PROCESS, 0))));
#endif
}

}  // namespace ui
