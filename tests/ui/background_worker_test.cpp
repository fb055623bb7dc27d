#include "ui/session/background_worker.h"

#include <chrono>
#include <stdexcept>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/ui/window_scenes.h"

namespace {

using namespace std::chrono_literals;
using tests::becomesTrue;

using Worker = ui::BackgroundWorker<int, std::vector<int>>;

TEST_CASE("A worker answers, and knows which request it answered") {
  Worker worker([](int request, auto& job) -> sim::Status {
    job.value = {request};
    return sim::Done{};
  });
  CHECK(worker.newest()->request == 0);
  CHECK_FALSE(worker.newest()->ended);
  CHECK_FALSE(worker.isBusy());
  CHECK(worker.request(7) == 1);
  REQUIRE(becomesTrue([&] { return worker.newest()->ended; }));
  CHECK(worker.newest()->request == 1);
  CHECK(worker.newest()->value == std::vector{7});
  CHECK_FALSE(worker.newest()->problem);
  CHECK_FALSE(worker.newest()->cancelled);
}

TEST_CASE("Of requests that come while a worker works, the newest counts") {
  auto open = std::make_shared<std::atomic<bool>>(false);
  auto seen = std::make_shared<std::atomic<int>>(0);
  Worker worker([open, seen](int request, auto& job) -> sim::Status {
    ++*seen;
    while (!*open) std::this_thread::sleep_for(1ms);
    job.value = {request};
    return sim::Done{};
  });
  worker.request(1);
  REQUIRE(becomesTrue([&] { return *seen == 1; }));
  for (int request = 2; request < 9; ++request) worker.request(request);
  CHECK(worker.isBusy());
  *open = true;
  REQUIRE(becomesTrue([&] { return !worker.isBusy(); }));
  CHECK(worker.newest()->value == std::vector{8});
  CHECK(worker.newest()->request == 8);
  CHECK(*seen == 2);
}

TEST_CASE("A worker shows how far it is, and stops when it is cancelled") {
  Worker worker([](int request, auto& job) -> sim::Status {
    while (!job.cancelled()) {
      job.value.push_back(request);
      job.publish();
      std::this_thread::sleep_for(1ms);
    }
    return sim::Problem{"", "stopped", ""};
  });
  worker.request(3);
  REQUIRE(becomesTrue([&] { return worker.newest()->value.size() > 2; }));
  CHECK_FALSE(worker.newest()->ended);
  worker.cancel();
  REQUIRE(becomesTrue([&] { return worker.newest()->ended; }));
  CHECK(worker.newest()->cancelled);
  // Who cancels need not be told that it did not end by itself.
  CHECK_FALSE(worker.newest()->problem);
}

TEST_CASE("A request that is cancelled before it was begun has ended, too") {
  auto open = std::make_shared<std::atomic<bool>>(false);
  Worker worker([open](int, auto&) -> sim::Status {
    while (!*open) std::this_thread::sleep_for(1ms);
    return sim::Done{};
  });
  worker.request(1);
  const std::uint64_t second = worker.request(2);
  worker.cancel();
  *open = true;
  REQUIRE(becomesTrue([&] { return !worker.isBusy(); }));
  CHECK(worker.newest()->ended);
  CHECK(worker.newest()->cancelled);
  CHECK(worker.newest()->request <= second);
}

TEST_CASE("What fails in a worker, or throws, is a Problem, and the worker goes on") {
  Worker worker([](int request, auto& job) -> sim::Status {
    job.value = {request};
    if (request == 1) return sim::Problem{"here", "it cannot be done", "try two"};
    if (request == 2) throw std::runtime_error("a surprise");
    if (request == 3) throw std::bad_alloc();
    if (request == 4) throw 4;
    return sim::Done{};
  });
  const auto problemOf = [&](int request) {
    worker.request(request);
    REQUIRE(becomesTrue([&] { return worker.newest()->ended && !worker.isBusy(); }));
    CHECK(worker.newest()->value == std::vector{request});
    return worker.newest()->problem.value_or(sim::Problem{}).what;
  };
  CHECK(problemOf(1) == "it cannot be done");
  CHECK(problemOf(2) == "this failed: a surprise");
  CHECK(problemOf(3) == "there is not enough memory for this");
  CHECK_FALSE(problemOf(4).empty());
  CHECK(problemOf(5).empty());
}

TEST_CASE("A worker ends in bounded time, whatever it does, and what it still does harms nobody") {
  auto finished = std::make_shared<std::atomic<bool>>(false);
  const auto start = std::chrono::steady_clock::now();
  {
    Worker worker([finished](int request, auto& job) -> sim::Status {
      // It does not look at whether it is wanted.
      std::this_thread::sleep_for(2s);
      job.value = {request};
      job.publish();
      *finished = true;
      return sim::Done{};
    });
    worker.request(1);
    std::this_thread::sleep_for(20ms);
  }
  CHECK(std::chrono::steady_clock::now() - start < 1s);
  CHECK_FALSE(*finished);
  CHECK(becomesTrue([&] { return finished->load(); }));
}

TEST_CASE("A worker that heeds its end has ended before it is gone") {
  auto ended = std::make_shared<std::atomic<bool>>(false);
  {
    Worker worker([ended](int, auto& job) -> sim::Status {
      while (!job.cancelled()) std::this_thread::sleep_for(1ms);
      *ended = true;
      return sim::Done{};
    });
    worker.request(1);
    REQUIRE(becomesTrue([&] { return worker.isBusy(); }));
    std::this_thread::sleep_for(20ms);
  }
  CHECK(*ended);
}

TEST_CASE("A worker that nobody asked anything ends at once") {
  const auto start = std::chrono::steady_clock::now();
  {
    Worker worker([](int, auto&) -> sim::Status { return sim::Done{}; });
  }
  CHECK(std::chrono::steady_clock::now() - start < 100ms);
}

}  // namespace
