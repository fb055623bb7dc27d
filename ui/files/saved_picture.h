#pragma once

#include <QImage>
#include <filesystem>

#include "sim/base/result.h"

namespace ui {

/// Writes it as PNG, whole or not at all (modeling/files/output_file.h).
sim::Status savePicture(const QImage& picture, const std::filesystem::path& file);

}  // namespace ui
