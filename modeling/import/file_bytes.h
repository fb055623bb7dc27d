#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "sim/base/result.h"

namespace modeling {

/// Larger files are refused before they are read, bytes.
inline constexpr std::uintmax_t kLargestMeshFile = 128U << 20U;

/// All bytes of a regular file. A Problem without a place where it is none, too large, or can't be read.
sim::Result<std::string> fileBytes(const std::filesystem::path& file);

}  // namespace modeling
