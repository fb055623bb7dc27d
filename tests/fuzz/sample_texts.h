#pragma once

#include <map>
#include <string>

namespace tests {

/// Scenes, networks, dumps and the program's own small files, by their paths in the folder of samples.
std::map<std::string, std::string> sampleTexts();

/// A glass that falls and breaks within a few frames.
std::string breakingScene();

}  // namespace tests
