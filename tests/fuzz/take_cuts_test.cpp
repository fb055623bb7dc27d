#include <algorithm>
#include <random>

#include <catch2/catch.hpp>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sim/take/frame_codec.h"
#include "sim/take/take.h"
#include "tests/fuzz/take_damage.h"
#include "tests/sim/take_sample.h"
#include "tests/support/grid_network.h"

using namespace tests;

namespace {

using Random = std::mt19937_64;
constexpr std::size_t kFrames = 12;
const std::string kSecondScene = "{\"someone\": \"poked it\"}";
const std::string kThirdScene = "{\"gravity\": 0}";
constexpr rlim_t kMostMemory = rlim_t{1} << 30;

std::size_t below(Random& random, std::size_t limit) {
  return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
}

void cutTail(std::vector<char>& bytes, Random& random) {
  bytes.resize(below(random, bytes.size()));
}

void flipBits(std::vector<char>& bytes, Random& random) {
  for (std::size_t n = 1 + below(random, 8); n > 0; --n) {
    bytes[below(random, bytes.size())] ^= static_cast<char>(1 << below(random, 8));
  }
}

void dropMiddle(std::vector<char>& bytes, Random& random) {
  const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(below(random, bytes.size()));
  bytes.erase(first, first + std::min<std::ptrdiff_t>(bytes.end() - first,
                                                      1 + static_cast<std::ptrdiff_t>(below(random, 500))));
}

void repeatMiddle(std::vector<char>& bytes, Random& random) {
  const std::size_t first = below(random, bytes.size());
  const std::size_t last = std::min(bytes.size(), first + below(random, 3000));
  const std::vector<char> piece(bytes.begin() + static_cast<std::ptrdiff_t>(first),
                                bytes.begin() + static_cast<std::ptrdiff_t>(last));
  bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(below(random, bytes.size())), piece.begin(),
               piece.end());
}

/// Something in a chunk or its header, under a checksum that is right.
void spoilSealed(std::vector<char>& bytes, Random& random) {
  std::string text(bytes.begin(), bytes.end());
  Chance chance(random());
  damageTake(text, chance);
  bytes.assign(text.begin(), text.end());
}

/// Reads all there is to be had, and goes on recording. False when a frame came back as it never was.
bool readEverything(const std::filesystem::path& path, const sim::Network& network, bool sealed) {
  std::size_t lastCheckpoint = kFrames;
  if (auto opened = sim::TakeReader::open(path); opened.ok()) {
    const sim::TakeReader& take = **opened;
    const sim::NetworkSize size = sim::NetworkSize::of(take.network());
    if (take.network().validate() || take.frameCount() > kFrames) return false;
    for (std::size_t frame = 0; frame < take.frameCount(); ++frame) {
      const auto read = take.frame(frame);
      (void)take.eventsOf(frame);
      const auto scene = take.sceneOf(frame);
      if (!sealed && scene && *scene != sampleHeader().scene && *scene != kSecondScene &&
          *scene != kThirdScene)
        return false;
      if (!read) continue;
      if (sim::faultOf(size, **read)) return false;
      const auto number = static_cast<std::size_t>((*read)->time * 240.0 + 0.5);
      if (!sealed && !identical(**read, sampleFrame(network, number))) return false;
    }
    (void)take.events();
    (void)take.outcome();
    for (const std::size_t frame : take.checkpointFrames()) {
      if (take.checkpoint(frame).ok()) lastCheckpoint = frame;
    }
  }
  (void)sim::TakeWriter::continueAfter(path, lastCheckpoint);
  return true;
}

/// In a process of its own, with no more memory than kMostMemory (a sanitizer's own needs don't count).
bool survives(const std::filesystem::path& path, const sim::Network& network, bool sealed) {
  const pid_t child = ::fork();
  if (child == 0) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    const rlimit limit{kMostMemory, kMostMemory};
    if (::setrlimit(RLIMIT_AS, &limit) != 0) ::_exit(2);
#endif
    ::_exit(readEverything(path, network, sealed) ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

TEST_CASE("a spoiled take gives problems or fewer frames, never a wrong frame, a crash or a gigabyte",
          "[take][fuzz]") {
  const ScratchFolder folder;
  const sim::Network network = gridNetwork(2, 2, 3);
  const auto path = folder.file("whole.take");
  {
    auto writer = sim::TakeWriter::create(path, sampleHeader(), network);
    REQUIRE(writer.ok());
    REQUIRE(appendSample(**writer, network, 0, 3).ok());
    REQUIRE((*writer)->appendScene(kSecondScene).ok());
    REQUIRE(appendSample(**writer, network, 3, 7).ok());
    REQUIRE((*writer)->beginScene(kThirdScene).ok());
    REQUIRE(appendSample(**writer, network, 7, kFrames).ok());
    REQUIRE((*writer)->finish("done").ok());
  }
  const std::vector<char> whole = fileBytes(path);
  REQUIRE(survives(path, network, false));
  using Spoil = void (*)(std::vector<char>&, Random&);
  const Spoil spoils[] = {cutTail, flipBits, dropMiddle, repeatMiddle, spoilSealed, spoilSealed, spoilSealed};
  for (unsigned seed = 0; seed < 140; ++seed) {
    Random random(seed);
    const std::size_t kind = seed % std::size(spoils);
    std::vector<char> bytes = whole;
    spoils[kind](bytes, random);
    const auto spoiled = folder.file("spoiled.take");
    writeBytes(spoiled, bytes);
    INFO("seed " << seed << ", kind " << kind);
    CHECK(survives(spoiled, network, kind >= 4));
  }
}
