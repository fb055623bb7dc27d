#pragma once

namespace ui {

/// The calling thread, and every thread it starts from now on, gives way to the threads that answer the
/// person and draw, where all processors are busy. Does nothing where the system has no priority of single
/// threads for programs without rights.
void giveWayToTheWindow();

}  // namespace ui
