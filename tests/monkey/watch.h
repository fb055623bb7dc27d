#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace monkey {

/// Megabytes of the process that are in memory, and those that the program asked for and did not give back.
struct Memory {
  double seconds = 0.0;  ///< since the start
  double resident = 0.0;
  double asked = 0.0;
  long widgets = 0;  ///< shown or not
};
Memory memoryNow();

/// The window did not come to answer for longer than it may.
struct Stall {
  double seconds = 0.0;  ///< by the clock
  double own = 0.0;      ///< without what the thread waited for a processor
  std::string during;    ///< the action
  bool drawing =
      false;  ///< the driver of OpenGL, which builds its programs when they are first needed, took the time
};

/// Watches the window from a thread of its own: whether it answers, and how much memory it takes. What the
/// driver of OpenGL takes is told, and is not of our making. Where it crashes, or does not answer for
/// minutes, the action and the calls that led there are written to stderr.
class Watch {
 public:
  static constexpr double kLongest = 2.0;  ///< s: what the window may let wait
  static constexpr double kDead = 180.0;   ///< s: then the program is ended

  Watch();
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// Says on stderr during what and by which calls the exception was thrown that was caught just now.
  static void tellThrow(const std::string& what);
  /// Which action is under way, for what is reported.
  void begin(const std::string& action);
  /// Those longer than kLongest.
  const std::vector<Stall>& stalls() const { return stalls_; }
  /// How many of them are of our own making.
  std::size_t ownStalls() const;
  double longest() const { return longest_; }
  /// Looks at the memory. What is open then is to be the same each time, or looks cannot be compared.
  void lookAtMemory();
  const std::vector<Memory>& memory() const { return memory_; }
  /// How much more the program has asked for at the end than after the first sixth, as a share of that.
  double growth() const;

 private:
  void beat();
  void main();

  QTimer timer_;
  QElapsedTimer clock_;
  std::atomic<qint64> beatAt_{0};  ///< ms
  std::atomic<bool> ends_{false};
  std::string action_;
  double waitedBefore_ = 0.0;  ///< s: for a processor, until the last beat
  double longest_ = 0.0;
  std::vector<Stall> stalls_;
  std::vector<Memory> memory_;
  std::thread thread_;
};

}  // namespace monkey
