#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// What the fuzz program damages, and what reads it.
namespace tests {

/// One kind of file: whole ones of our own making, and the program's own way to read them.
struct FuzzKind {
  std::string name;
  std::string ending;               ///< of the file's name
  std::vector<std::string> wholes;  ///< each is read without a Problem
  bool isText = false;
  /// Reads the file with all that follows from it. Throws and crashes where the program would. Answers
  /// whether it was good; a Problem has words.
  bool (*read)(const std::filesystem::path& file);
};

/// Makes the whole files in a folder that is there.
std::vector<FuzzKind> fuzzKinds(const std::filesystem::path& folder);

/// The whole file with one to three damages, drawn from the seed.
std::string spoiled(const FuzzKind& kind, std::uint64_t seed);

}  // namespace tests
