#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/bytes.h"

namespace modeling {

/// What a reading process may take.
struct ReadingLimits {
  unsigned seconds = 60;                     ///< of the processor, and twice as many by the clock
  std::size_t memory = 2UL << 30U;           ///< bytes, beyond what it begins with
  std::size_t longestAnswer = 512UL << 20U;  ///< bytes
};

/// What came of it.
enum class ReadingEnd {
  answered,
  failed,   ///< the reader itself came to grief
  tooLong,  ///< it took more than the time or the answer it may
  givenUp,  ///< keepGoing said no
  notNow,   ///< the system gives no process
};

struct ReadingAnswer {
  ReadingEnd end = ReadingEnd::failed;
  std::vector<std::byte> bytes;  ///< where it answered
};

/// Does the reading of a foreign file in a process of its own, so that whatever the reader does to itself or
/// however long it takes, nothing happens here. `read` runs there, and what it gives comes back; what it
/// throws is a failure. `keepGoing` is asked ten times a second; the process ends where it says no. To be
/// called where waiting is allowed.
ReadingAnswer readApart(const std::function<sim::ByteWriter()>& read, const ReadingLimits& limits,
                        const std::function<bool()>& keepGoing = {});

}  // namespace modeling
