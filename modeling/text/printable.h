#pragma once

#include <string>
#include <string_view>

namespace modeling {

/// Text of a file, a name or a path as a terminal may be given it, on one line: what would move the cursor,
/// colour, hide or turn round what stands beside it is written as an escape (\x1b, \u202e), and so is what is
/// no UTF-8. All else is left as it is.
std::string printable(std::string_view text);

}  // namespace modeling
