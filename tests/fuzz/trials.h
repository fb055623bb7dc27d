#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tests {

/// What came of trying an input: it was read, and what was made of it, or "refused: " and the problem's line.
/// What must never be begins with "WRONG: ".
using Finding = std::string;

/// Tries one input with the program's own functions, as far as it is sound: a scene is read, salvaged,
/// written, built, gone over by the pre-flight and stepped; a take is read to the end, and drawn and
/// continued from; the others likewise. `file` stands in a folder with what it needs, in which may be
/// written. Runs loops in parallel, and may do whatever a fault does: to be called in a process of its own.
Finding tryInput(std::string_view kind, const std::filesystem::path& file);

/// Those of the window: the lists of takes that are kept with scenes, and what a killed program left behind.
Finding tryKeptTakes(const std::filesystem::path& index);
Finding tryRecovery(const std::filesystem::path& folder);

/// Such as a problem must be: one line for a person, short, with what is wrong in it.
Finding refusal(const std::string& place, const std::string& what, const std::string& remedy);

}  // namespace tests
