#include "ui/timeline/track_following.h"

#include <algorithm>

namespace ui {
namespace {

/// What is equal at both ends of the lists has only moved along. What lies between these ends was changed
/// where it stands if there are as many as before and `alike(before, after)` says so.
template <class Item, class Alike>
std::optional<std::size_t> followed(const std::vector<Item>& before, const std::vector<Item>& after,
                                    std::size_t index, const Alike& alike) {
  if (index >= before.size()) return std::nullopt;
  const std::size_t shorter = std::min(before.size(), after.size());
  std::size_t head = 0;
  while (head < shorter && before[head] == after[head]) ++head;
  std::size_t tail = 0;
  while (tail < shorter - head && before[before.size() - 1 - tail] == after[after.size() - 1 - tail]) ++tail;
  if (index < head) return index;
  if (index >= before.size() - tail) return index + after.size() - before.size();
  if (before.size() == after.size() && alike(before[index], after[index])) return index;
  return std::nullopt;
}

}  // namespace

std::optional<std::size_t> followedTrack(const Tracks& before, const Tracks& after, std::size_t track) {
  return followed(before, after, track,
                  [](const modeling::SceneTrack& left, const modeling::SceneTrack& right) {
                    return left.target == right.target || left.keys == right.keys;
                  });
}

std::optional<KeyPlace> followedKey(const Tracks& before, const Tracks& after, const KeyPlace& place) {
  const std::optional<std::size_t> track = followedTrack(before, after, place.track);
  if (!track) return std::nullopt;
  const std::optional<std::size_t> key = followed(before[place.track].keys, after[*track].keys, place.key,
                                                  [](const auto&, const auto&) { return true; });
  if (!key) return std::nullopt;
  return KeyPlace{*track, *key};
}

}  // namespace ui
