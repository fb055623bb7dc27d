#include "ui/window/memory.h"

#include <QTimer>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace ui {
namespace {

/// Bytes: larger blocks are mappings of their own. A frame of a cup has about so many.
[[maybe_unused]] constexpr int kMapped = 256 * 1024;
/// Bytes at the end of a heap that are kept for what comes next.
[[maybe_unused]] constexpr int kKept = 1024 * 1024;
/// Of all threads together. They compute more than they allocate.
[[maybe_unused]] constexpr int kHeaps = 4;
/// ms. It takes a few ms itself.
constexpr int kNowAndThen = 15'000;

}  // namespace

void shareHeaps() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, kMapped);
  mallopt(M_TRIM_THRESHOLD, kKept);
  mallopt(M_ARENA_MAX, kHeaps);
#endif
}

void giveBackNowAndThen(QObject& owner) {
  auto* timer = new QTimer(&owner);
  QObject::connect(timer, &QTimer::timeout, timer, [] {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
  });
  timer->start(kNowAndThen);
}

}  // namespace ui
