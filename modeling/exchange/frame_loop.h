#pragma once

#include <functional>

#include "modeling/exchange/export.h"

namespace modeling {

/// Does something with every requested frame in order, and tells the request's progress. The first Problem
/// ends it: of a frame that cannot be read, of `write`, or that the export was cancelled.
sim::Status forEachFrame(
    const sim::TakeReader& take, const ExportRequest& request,
    const std::function<sim::Status(std::size_t index, const sim::Snapshot& frame)>& write);

/// The path itself where one frame is asked for, else numbered by the frame.
std::filesystem::path framePath(const ExportRequest& request, std::size_t frame);

/// Of a table beside the main one: "folder/name.csv" and "events" -> "folder/name.events.csv".
std::filesystem::path sideTable(const std::filesystem::path& path, const std::string& name);

/// The last frame's breaks, where everything was in the first: what is exported with one topology for all
/// frames.
sim::Snapshot splitAtStart(const sim::Snapshot& first, const sim::Snapshot& last);

}  // namespace modeling
