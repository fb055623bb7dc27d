#pragma once

#include <optional>
#include <vector>

#include "ui/timeline/track_layout.h"

/// Where a track or a key is after the tracks of a scene have been changed, by whomever: what is selected,
/// grabbed or typed into stays with it, and is let go where it is gone.
namespace ui {

using Tracks = std::vector<modeling::SceneTrack>;

/// Nothing where it is gone. Tracks that are equal before and after have only moved along; one that was
/// changed where it stands is the same as long as it drives the same or has the same keys.
std::optional<std::size_t> followedTrack(const Tracks& before, const Tracks& after, std::size_t track);
/// Nothing where the key or its track is gone.
std::optional<KeyPlace> followedKey(const Tracks& before, const Tracks& after, const KeyPlace& place);

}  // namespace ui
