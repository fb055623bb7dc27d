#pragma once

class QObject;

namespace ui {

/// Lets what is freed go back to the system, where the library for memory is glibc's; elsewhere it does
/// nothing. To be called before the first thread is started.
///
/// Left to itself, glibc gives each thread a heap of its own, up to eight a processor, and raises the size
/// from which a block is a mapping of its own to 32 MB as soon as one such is freed. The arrays of lattices,
/// frames and pictures, which come and go in many threads, then lie in those heaps, which grow to several
/// times of what is in use and never shrink.
void shareHeaps();

/// Gives pages back that are free in the middle of heaps, from time to time, as long as `owner` lives.
void giveBackNowAndThen(QObject& owner);

}  // namespace ui
