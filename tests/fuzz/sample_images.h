#pragma once

#include <filesystem>
#include <string>

namespace tests {

/// How the scanlines of a Radiance picture are stored.
enum class RadianceRuns { none, old, modern };

/// A Radiance picture of a smooth sky, of which rows repeat; twice as wide as high.
std::string radiancePicture(int height, RadianceRuns runs);

/// flat.hdr, runs.hdr, old-runs.hdr, sky.exr and sky.png.
void writeSampleImages(const std::filesystem::path& folder);

}  // namespace tests
