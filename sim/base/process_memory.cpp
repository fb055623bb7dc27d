#include "sim/base/process_memory.h"

#include <fstream>

#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace sim {

std::size_t residentMemory() {
#ifdef __linux__
  std::ifstream sizes("/proc/self/statm");
  std::size_t all = 0, resident = 0;
  if (sizes >> all >> resident) return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
#endif
  return 0;
}

std::size_t peakMemory() {
#if defined(__unix__) || defined(__APPLE__)
  rusage used{};
  if (::getrusage(RUSAGE_SELF, &used) != 0) return 0;
  const auto most = static_cast<std::size_t>(used.ru_maxrss);
#ifdef __APPLE__
  return most;
#else
  return 1024 * most;
#endif
#else
  return 0;
#endif
}

}  // namespace sim
