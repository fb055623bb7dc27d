#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace modeling {

/// The candidate that takes the fewest edits (insert, delete, replace, swap neighbours; case does not count)
/// to become `word`; the first of equals; "" when there are no candidates.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// "did you mean "density"", or "there is none" when there are no candidates: the usual remedy for an unknown
/// name.
std::string didYouMean(std::string_view word, const std::vector<std::string>& candidates);

/// `text` in quotation marks, for messages: on one line, without control characters, cut when long.
std::string inQuotes(std::string_view text);

}  // namespace modeling
