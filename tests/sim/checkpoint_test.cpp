#include <algorithm>

#include <catch2/catch.hpp>
#include <xxhash.h>

#include "sim/base/random.h"
#include "tests/support/crash.h"

namespace {

constexpr double kUntil = 0.003;

std::uint64_t draw(std::uint64_t seed, std::uint64_t counter, std::uint64_t below) {
  return static_cast<std::uint64_t>(sim::uniformAt(seed, counter) * static_cast<double>(below));
}

/// What a run shows of itself at its end.
struct Ending {
  std::uint64_t hash = 0;
  std::uint64_t steps = 0;
  double maxRise = 0.0;
  double dissipated = 0.0;
  std::size_t fragments = 0;
  std::uint64_t labelings = 0;

  bool operator==(const Ending&) const = default;
};

Ending endingOf(const sim::Simulation& simulation) {
  const sim::Snapshot snapshot = simulation.snapshot();
  return {simulation.stateHash(),    simulation.stepCount(),
          simulation.maxRise(),      snapshot.ledger.energy.dissipated,
          snapshot.fragments.size(), simulation.work().labelings};
}

void checkResuming(const tests::CrashOptions& options) {
  const auto whole = tests::crash(options);
  tests::run(*whole, kUntil);
  const Ending expected = endingOf(*whole);
  REQUIRE(whole->brokenBondCount() > 50);
  REQUIRE(expected.fragments > 3);
  for (std::uint64_t k = 0; k < 8; ++k) {
    const auto first = tests::crash(options);
    const std::uint64_t cut = draw(options.seed, k, expected.steps);
    for (std::uint64_t n = 0; n < cut; ++n) REQUIRE(first->stepOnce().ok());
    const std::vector<std::byte> checkpoint = first->checkpoint();

    tests::CrashOptions moreThreads = options;
    moreThreads.threads = 2;
    const auto resumed = tests::crash(moreThreads);
    REQUIRE(resumed->restore(checkpoint).ok());
    CHECK(resumed->stateHash() == first->stateHash());
    CHECK(resumed->time() == first->time());
    CHECK(resumed->checkpoint() == checkpoint);
    tests::run(*resumed, kUntil);
    CHECK(endingOf(*resumed) == expected);
  }
}

TEST_CASE("a run resumed from any step ends like the unbroken one, bit for bit") {
  const std::uint64_t seed = GENERATE(1, 2, 3);
  checkResuming({.seed = seed});
}

TEST_CASE("a run that fell on a mesh is resumed bit for bit, too") {
  checkResuming({.onSheet = true});
}

TEST_CASE("a run can be taken back to where it was") {
  const auto run = tests::crash({});
  tests::run(*run, 0.5 * kUntil);
  const std::vector<std::byte> checkpoint = run->checkpoint();
  tests::run(*run, kUntil);
  const Ending expected = endingOf(*run);
  REQUIRE(run->restore(checkpoint).ok());
  tests::run(*run, kUntil);
  CHECK(endingOf(*run) == expected);
}

TEST_CASE(
    "snapshots between two breaks share what is broken, and a resumed run calls it by the same version") {
  const auto whole = tests::crash({});
  const auto resumed = tests::crash({});
  std::vector<std::uint64_t> versions{whole->snapshot().broken->version};
  std::uint64_t bonds = 0;
  while (whole->time() < kUntil) {
    const sim::BrokenPointer before = whole->snapshot().broken;
    REQUIRE(whole->stepOnce().ok());
    const sim::BrokenPointer now = whole->snapshot().broken;
    const bool broke = whole->brokenBondCount() != bonds;
    bonds = whole->brokenBondCount();
    REQUIRE((now == before) == !broke);
    REQUIRE(now->lostBonds() == bonds);
    if (!broke) continue;
    REQUIRE(std::ranges::find(versions, now->version) == versions.end());
    versions.push_back(now->version);
    if (versions.size() % 4 != 0) continue;
    // Whatever was looked at there before.
    static_cast<void>(resumed->snapshot());
    REQUIRE(resumed->restore(whole->checkpoint()).ok());
    REQUIRE(resumed->snapshot().broken->version == now->version);
  }
  CHECK(versions.size() > 10);
}

std::vector<std::byte> midwayCheckpoint() {
  const auto run = tests::crash({});
  tests::run(*run, 0.6 * kUntil);
  return run->checkpoint();
}

/// The last eight bytes are the hash of all before them.
void sealAnew(std::vector<std::byte>& checkpoint) {
  const std::uint64_t seal = XXH3_64bits(checkpoint.data(), checkpoint.size() - 8);
  std::memcpy(checkpoint.data() + checkpoint.size() - 8, &seal, 8);
}

TEST_CASE("a checkpoint of another version is refused as that, not as damaged") {
  std::vector<std::byte> older = midwayCheckpoint();
  std::uint32_t version = 0;
  std::memcpy(&version, older.data(), sizeof version);
  --version;
  std::memcpy(older.data(), &version, sizeof version);
  sealAnew(older);
  const auto target = tests::crash({});
  const std::uint64_t before = target->stateHash();
  const sim::Status status = target->restore(older);
  REQUIRE_FALSE(status.ok());
  CHECK(status.problem().what.find("another version") != std::string::npos);
  CHECK(status.problem().remedy.find("--from") != std::string::npos);
  CHECK(target->stateHash() == before);
}

TEST_CASE("a cut or flipped checkpoint is refused and changes nothing") {
  const std::vector<std::byte> sound = midwayCheckpoint();
  const auto target = tests::crash({});
  tests::run(*target, 0.3 * kUntil);
  const std::uint64_t before = target->stateHash();
  for (std::uint64_t k = 0; k < 200; ++k) {
    std::vector<std::byte> damaged = sound;
    if (k % 2 == 0) {
      damaged.resize(draw(5, k, sound.size()));
    } else {
      damaged[draw(5, k, sound.size())] ^= std::byte{1} << static_cast<int>(draw(6, k, 8));
    }
    const sim::Status status = target->restore(damaged);
    REQUIRE_FALSE(status.ok());
    REQUIRE(status.problem().place == "checkpoint");
    REQUIRE(target->stateHash() == before);
  }
  REQUIRE(target->restore(sound).ok());
}

TEST_CASE("a checkpoint that is wrong but well sealed does no harm") {
  // As from a hostile file: most flips land in numbers, which then are merely others; those that land in
  // indices and counts must be seen. Resuming may go wrong in any way but out of bounds.
  const std::vector<std::byte> sound = midwayCheckpoint();
  int refused = 0;
  for (std::uint64_t k = 0; k < 200; ++k) {
    std::vector<std::byte> forged = sound;
    for (int flip = 0; flip < 4; ++flip) {
      const std::uint64_t counter = 4 * k + static_cast<std::uint64_t>(flip);
      forged[draw(7, counter, sound.size() - 8)] = static_cast<std::byte>(draw(8, counter, 256));
    }
    sealAnew(forged);
    const auto target = tests::crash({});
    if (!target->restore(forged).ok()) {
      ++refused;
      continue;
    }
    for (int n = 0; n < 3; ++n) {
      if (!target->stepOnce().ok()) break;
    }
    target->snapshot();
  }
  CHECK(refused > 10);
}

TEST_CASE("a checkpoint of another network is refused") {
  const auto pair = tests::simulation(tests::twoNodes({}), tests::losslessSettings());
  CHECK_FALSE(pair->restore(midwayCheckpoint()).ok());
  CHECK_FALSE(pair->restore({}).ok());
}

}  // namespace
