#pragma once

#include <string>

#include "tests/fuzz/chance.h"

namespace tests {

/// Changes the structure of a JSON text, or a value in it; a text that is none stays as it is.
void damageJson(std::string& text, Chance& chance);

}  // namespace tests
