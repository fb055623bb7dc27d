#pragma once

#include <string>
#include <string_view>

namespace sim {

/// 32 hexadecimal digits that tell texts apart.
std::string textHash(std::string_view text);

}  // namespace sim
