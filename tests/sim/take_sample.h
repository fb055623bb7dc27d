#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/take/take.h"

/// A small run made by hand, every frame of it a function of its number alone, so that what comes out of a
/// take can be compared with what went in wherever the take was written.
namespace tests {

inline constexpr std::size_t kFramesPerCheckpoint = 4;

sim::TakeHeader sampleHeader();
/// A block that falls, shakes and breaks at every third frame.
sim::Snapshot sampleFrame(const sim::Network& network, std::size_t number);
/// The break at every third frame; none at the others.
std::vector<sim::BreakEvent> sampleEvents(const sim::Network& network, std::size_t number);
/// Not compressible, as states are not.
std::vector<std::byte> sampleCheckpoint(std::size_t number);
/// Frames [first, last), each with its events and, where due, its checkpoint.
sim::Status appendSample(sim::TakeWriter& writer, const sim::Network& network, std::size_t first,
                         std::size_t last);

/// Equal in every bit of every double; NaNs too.
bool identical(const sim::Snapshot& a, const sim::Snapshot& b);
bool identical(const std::vector<sim::BreakEvent>& a, const std::vector<sim::BreakEvent>& b);

std::vector<char> fileBytes(const std::filesystem::path& path);
void writeBytes(const std::filesystem::path& path, const std::vector<char>& bytes);

/// A folder of this test's own that goes when it does.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  std::filesystem::path file(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace tests
