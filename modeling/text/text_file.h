#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "sim/base/result.h"
#include "sim/base/text_hash.h"

namespace modeling {

using sim::textHash;

/// The bytes of a file, when it is a regular one and not above `largest`.
sim::Result<std::string> readTextFile(const std::filesystem::path& file, std::uintmax_t largest);

/// Replaces the file in one step: whatever happens, the old text or the new one is there, whole
/// (modeling/files/output_file.h).
sim::Status replaceTextFile(const std::filesystem::path& file, std::string_view text);

}  // namespace modeling
