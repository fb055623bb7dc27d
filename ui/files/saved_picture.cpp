#include "ui/files/saved_picture.h"

#include <QBuffer>

#include "modeling/files/output_file.h"

namespace ui {

sim::Status savePicture(const QImage& picture, const std::filesystem::path& file) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!picture.save(&buffer, "PNG"))
    return sim::Problem{file.string(), "this picture cannot be written", "make it smaller"};
  return modeling::replaceFile(file, bytes.toStdString());
}

}  // namespace ui
