#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "modeling/import/attendance.h"
#include "sim/base/bytes.h"
#include "sim/base/result.h"

/// Files of other programs are read in a process of its own, so that nothing a file does to its reader does
/// anything to us: it may crash, hang or take all memory.
namespace modeling {

/// What one reading may take.
struct ReadingLimits {
  double seconds = 60.0;                       ///< by the clock and by the processor
  std::size_t memory = std::size_t{2} << 30U;  ///< bytes, beyond what the program has
};

/// Calls `read` in a process of its own and brings back what it has written; `name` is what is read, for a
/// person. Waits for it no longer than the limits allow, and ends it when the attendance gives up. What
/// `read` does to the memory of the program is not seen by the program. It must not start threads nor wait
/// for any.
///
/// The Problem has no place, and tells apart that the reader failed (it crashed or threw), took too long,
/// took too much memory, was given up, or could not be started.
sim::Result<std::vector<std::byte>> readApart(const std::string& name,
                                              const std::function<sim::ByteWriter()>& read,
                                              const ReadingLimits& limits = {},
                                              const Attendance& attendance = {});

}  // namespace modeling
