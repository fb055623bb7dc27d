#pragma once

#include <cstdint>
#include <string>

namespace tests {

/// How an input is made up, which decides what damage may still be read some way into it.
enum class Nature {
  text,    ///< lines of words and numbers
  json,    ///< so that structure can be damaged too
  binary,  ///< counts and offsets of one to eight bytes, most of them near the beginning
  take,    ///< chunks with checksums, which are sealed again
};

/// One damage, drawn from the seed: bits flipped, the end cut off, a stretch dropped, repeated or
/// overwritten, the front joined to the end of `other` (another input of the same kind), numbers replaced by
/// extreme ones, values of JSON removed, exchanged, multiplied or nested, contents of a take changed under a
/// right checksum. The same for the same arguments, everywhere.
std::string damagedInput(const std::string& whole, const std::string& other, Nature nature,
                         std::uint64_t seed);

}  // namespace tests
