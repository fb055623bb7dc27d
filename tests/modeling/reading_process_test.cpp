#include "modeling/import/reading_process.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include <catch2/catch.hpp>

#include "modeling/import/raw_mesh.h"

/// A reader in a process of its own, and readers that are told to misbehave.
namespace {

using modeling::readApart;
using modeling::ReadingLimits;
using Clock = std::chrono::steady_clock;

sim::ByteWriter nothing() {
  return {};
}

sim::ByteWriter slowly() {
  std::this_thread::sleep_for(std::chrono::seconds(20));
  return {};
}

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

TEST_CASE("what a reader in a process of its own has read comes back, however long it is") {
  std::vector<std::uint64_t> numbers(300'000);
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = i * i;
  const auto bytes = readApart("numbers", [&] {
    sim::ByteWriter writer;
    writer.putVector(numbers);
    return writer;
  });
  REQUIRE(bytes.ok());
  std::vector<std::uint64_t> back;
  CHECK(sim::ByteReader(*bytes).readVector(back));
  CHECK(back == numbers);
  CHECK(readApart("nothing", nothing)->empty());
}

TEST_CASE("a reader that takes too long is ended, and that is what is said") {
  const auto start = Clock::now();
  const auto bytes = readApart("cup.fbx", slowly, {.seconds = 0.3});
  // A second for a busy machine to end it.
  CHECK(secondsSince(start) < 1.5);
  REQUIRE_FALSE(bytes.ok());
  CHECK_THAT(bytes.problem().what, Catch::Contains("took longer than"));
}

TEST_CASE("a reader that works without an end is ended by its share of the processor, too") {
  const auto bytes = readApart("cup.fbx",
                               [] {
                                 volatile std::uint64_t count = 0;
                                 while (count + 1 > 0) count = count + 1;
                                 return sim::ByteWriter();
                               },
                               {.seconds = 0.3});
  REQUIRE_FALSE(bytes.ok());
  CHECK_THAT(bytes.problem().what, Catch::Contains("took longer than"));
}

TEST_CASE("who waits for a slow reader is told, and can give up") {
  std::vector<std::string> told;
  const auto start = Clock::now();
  const modeling::Attendance attendance{[&](const std::string& words) { told.push_back(words); },
                                        [&] { return told.size() >= 2; }};
  const auto bytes = readApart("cup.fbx", slowly, {}, attendance);
  CHECK(secondsSince(start) < 4.0);
  REQUIRE_FALSE(bytes.ok());
  CHECK_THAT(bytes.problem().what, Catch::Contains("given up"));
  REQUIRE_FALSE(told.empty());
  CHECK(told.front() == "reading cup.fbx, 1 s");
}

TEST_CASE("a reader that fails is told from a file that is wrong") {
  for (const auto& failure : std::vector<std::function<sim::ByteWriter()>>{
           [] {
             std::abort();
             return sim::ByteWriter();
           },
           []() -> sim::ByteWriter { throw std::runtime_error("no"); },
           [] {
             std::_Exit(0);
             return sim::ByteWriter();
           }}) {
    const auto bytes = readApart("cup.fbx", failure);
    // One that ends without a word has answered nothing, which is no mesh.
    const auto mesh = bytes.ok() ? modeling::readingOf(*bytes) : modeling::Reading(bytes.problem());
    REQUIRE_FALSE(mesh.ok());
    CHECK_THAT(mesh.problem().what, Catch::Contains("the reader of this format failed"));
    CHECK_FALSE(mesh.problem().remedy.empty());
  }
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_CASE("a reader that takes too much memory is told of") {
  const auto bytes = readApart("cup.fbx",
                               [] {
                                 std::vector<char> much(std::size_t{1} << 30U, 'x');
                                 sim::ByteWriter writer;
                                 writer.put(much[much.size() / 2]);
                                 return writer;
                               },
                               {.memory = std::size_t{64} << 20U});
  REQUIRE_FALSE(bytes.ok());
  CHECK_THAT(bytes.problem().what, Catch::Contains("more than 64 MB of memory"));
}
#endif

}  // namespace
