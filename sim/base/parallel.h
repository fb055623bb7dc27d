#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#if defined(__SANITIZE_THREAD__)
#include <thread>

#include <tbb/task_arena.h>
#endif

/// The only way in which loops run on several threads. Which thread does what, and when, is left open: a body
/// writes nothing but what belongs to its own indices, and does not throw. Both functions return when all is
/// done.
namespace sim {

enum class Sharing {
  balanced,  ///< idle threads take from busy ones: for indices of uneven cost
  even,      ///< each thread gets the same range every time, which is still in its cache
};

/// Calls body(begin, end) for ranges of at least about `grain` indices that together make [0, count).
template <class Body>
void parallelRanges(std::size_t count, std::size_t grain, Sharing sharing, const Body& body) {
#if defined(__SANITIZE_THREAD__)
  // The sanitizer does not see how a TBB that was built without it hands work over, and would find races
  // everywhere.
  const auto most = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  const std::size_t pieces = std::clamp<std::size_t>(count / grain, 1, most);
  std::vector<std::jthread> threads;
  for (std::size_t i = 1; i < pieces; ++i)
    threads.emplace_back([=, &body] { body(count * i / pieces, count * (i + 1) / pieces); });
  if (count > 0) body(std::size_t{0}, count / pieces);
  static_cast<void>(sharing);
#else
  const tbb::blocked_range<std::size_t> range(0, count, grain);
  const auto call = [&](const tbb::blocked_range<std::size_t>& part) { body(part.begin(), part.end()); };
  if (sharing == Sharing::even) {
    tbb::parallel_for(range, call, tbb::static_partitioner());
  } else {
    tbb::parallel_for(range, call);
  }
#endif
}

/// Calls body(index) for each index of [0, count).
template <class Body>
void parallelFor(std::size_t count, const Body& body) {
  parallelRanges(count, 1, Sharing::balanced, [&](std::size_t begin, std::size_t end) {
    for (std::size_t index = begin; index < end; ++index) body(index);
  });
}

/// What visit(index, found) appends to `found` for each index of [0, count), in the order of the indices, for
/// any number of threads.
template <class Item, class Visit>
std::vector<Item> collectInOrder(std::size_t count, std::size_t grain, const Visit& visit) {
  const std::size_t tasks = (count + grain - 1) / grain;
  std::vector<std::vector<Item>> parts(tasks);
  parallelFor(tasks, [&](std::size_t task) {
    const std::size_t end = std::min(count, (task + 1) * grain);
    for (std::size_t index = task * grain; index < end; ++index) visit(index, parts[task]);
  });
  std::vector<Item> all;
  for (std::vector<Item>& part : parts) {
    if (all.empty()) {
      all.swap(part);
    } else {
      all.insert(all.end(), part.begin(), part.end());
    }
  }
  return all;
}

}  // namespace sim
