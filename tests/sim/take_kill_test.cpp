#include <chrono>
#include <random>
#include <thread>

#include <catch2/catch.hpp>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sim/take/take.h"
#include "tests/sim/take_sample.h"
#include "tests/support/grid_network.h"

using namespace tests;

namespace {

constexpr std::size_t kEndless = 1'000'000;

/// Records without end, telling the pipe of every frame that was appended.
[[noreturn]] void recordUntilKilled(const std::filesystem::path& path, const sim::Network& network,
                                    int pipe) {
  auto writer = sim::TakeWriter::create(path, sampleHeader(), network);
  for (std::size_t frame = 0; writer.ok() && frame < kEndless; ++frame) {
    if (!appendSample(**writer, network, frame, frame + 1).ok()) break;
    if (::write(pipe, "f", 1) != 1) break;
  }
  ::_exit(1);
}

/// The number of frames a recorder that was killed after `delay` said it had appended.
std::size_t recordAndKill(const std::filesystem::path& path, const sim::Network& network,
                          std::chrono::microseconds delay) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) recordUntilKilled(path, network, ends[1]);
  ::close(ends[1]);
  char byte = 0;
  std::size_t appended = ::read(ends[0], &byte, 1) == 1 ? 1 : 0;
  std::this_thread::sleep_for(delay);
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  while (::read(ends[0], &byte, 1) == 1) ++appended;
  ::close(ends[0]);
  REQUIRE(WIFSIGNALED(status));
  return appended;
}

/// Runs `body` in a process of its own, and says whether it returned true.
template <class Body>
bool inChild(Body body) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(body() ? 0 : 1);
  int status = 0;
  ::waitpid(child, &status, 0);
  return child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

TEST_CASE("a recording killed at any moment has every frame it had appended, and goes on", "[take]") {
  const ScratchFolder folder;
  const sim::Network network = gridNetwork(8, 8, 8);
  const auto path = folder.file("killed.take");
  std::mt19937 random(20);
  std::uniform_int_distribution<int> microseconds(0, 8000);
  for (int round = 0; round < 20; ++round) {
    const std::size_t appended =
        recordAndKill(path, network, std::chrono::microseconds(microseconds(random)));
    REQUIRE(appended > 0);
    std::size_t lastCheckpoint = 0;
    {
      auto take = sim::TakeReader::open(path);
      REQUIRE(take.ok());
      CHECK((*take)->frameCount() >= appended);
      CHECK((*take)->frameCount() <= appended + 1);
      for (std::size_t frame = 0; frame < (*take)->frameCount(); ++frame) {
        CHECK(identical(**(*take)->frame(frame), sampleFrame(network, frame)));
      }
      CHECK_FALSE((*take)->outcome().has_value());
      if ((*take)->checkpointFrames().empty()) continue;
      lastCheckpoint = (*take)->checkpointFrames().back();
      CHECK(lastCheckpoint + kFramesPerCheckpoint >= appended - 1);
    }
    auto writer = sim::TakeWriter::continueAfter(path, lastCheckpoint);
    REQUIRE(writer.ok());
    REQUIRE(appendSample(**writer, network, lastCheckpoint + 1, lastCheckpoint + 3).ok());
    auto take = sim::TakeReader::open(path);
    REQUIRE(take.ok());
    CHECK((*take)->frameCount() == lastCheckpoint + 3);
    CHECK((*take)->droppedBytes() == 0);
  }
}

TEST_CASE("a full disk is a problem and leaves every frame before it", "[take]") {
  const ScratchFolder folder;
  const sim::Network network = gridNetwork(2, 2, 2);
  const auto path = folder.file("full.take");
  // The limit on the size of files stands in for the end of the disk: a write up to it is short, the next
  // fails.
  const bool behaved = inChild([&] {
    ::signal(SIGXFSZ, SIG_IGN);
    auto writer = sim::TakeWriter::create(path, sampleHeader(), network);
    if (!writer.ok() || !appendSample(**writer, network, 0, 3).ok()) return false;
    const auto size = std::filesystem::file_size(path);
    const rlimit limit{size + 1000, RLIM_INFINITY};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) return false;
    const auto full = (*writer)->appendFrame(sampleFrame(network, 3), {});
    if (full.ok() || full.problem().remedy.empty() || std::filesystem::file_size(path) != size) return false;
    // Room is made, and the recording goes on as if nothing had been.
    const rlimit none{RLIM_INFINITY, RLIM_INFINITY};
    if (::setrlimit(RLIMIT_FSIZE, &none) != 0) return false;
    return appendSample(**writer, network, 3, 5).ok();
  });
  CHECK(behaved);
  auto take = sim::TakeReader::open(path);
  REQUIRE(take.ok());
  REQUIRE((*take)->frameCount() == 5);
  CHECK((*take)->droppedBytes() == 0);
  CHECK(identical(**(*take)->frame(3), sampleFrame(network, 3)));

  const auto full = sim::TakeWriter::create("/dev/full", sampleHeader(), network);
  REQUIRE_FALSE(full.ok());
  CHECK(full.problem().remedy == "free some room, or record to another disk");
  CHECK(sim::TakeWriter::create("/dev/null", sampleHeader(), network).ok());
  CHECK_FALSE(sim::TakeWriter::create(folder.file("no/such/folder.take"), sampleHeader(), network).ok());
}

TEST_CASE("a take has one writer at a time, and readers look on", "[take]") {
  const ScratchFolder folder;
  const sim::Network network = gridNetwork(1, 1, 1);
  const auto path = folder.file("busy.take");
  {
    auto writer = sim::TakeWriter::create(path, sampleHeader(), network);
    REQUIRE(writer.ok());
    REQUIRE(appendSample(**writer, network, 0, 2).ok());
    const auto bytes = fileBytes(path);
    const auto second = sim::TakeWriter::create(path, sampleHeader(), network);
    REQUIRE_FALSE(second.ok());
    CHECK(second.problem().what == "this take is being recorded by another program");
    CHECK_FALSE(sim::TakeWriter::continueAfter(path, 0).ok());
    CHECK(fileBytes(path) == bytes);
    auto take = sim::TakeReader::open(path);
    REQUIRE(take.ok());
    CHECK((*take)->frameCount() == 2);
  }
  CHECK(sim::TakeWriter::continueAfter(path, 0).ok());
}
