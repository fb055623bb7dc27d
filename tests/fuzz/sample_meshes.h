#pragma once

#include <map>
#include <string>

namespace tests {

/// A box and balls, closed, in the formats that meshes are read from, by file name.
std::map<std::string, std::string> sampleMeshes();

}  // namespace tests
