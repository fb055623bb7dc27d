#pragma once

#include <QOpenGLFunctions_3_3_Core>
#include <cstdint>
#include <vector>

namespace ui {

using Gl = QOpenGLFunctions_3_3_Core;

/// What drawing costs, for whoever wants to know.
struct DrawStatistics {
  std::uint64_t drawCalls = 0;      ///< of the last picture
  std::uint64_t uploadedBytes = 0;  ///< for the last picture
  std::uint64_t uploadsInAll = 0;   ///< since the start
  double paintMilliseconds = 0.0;   ///< of this thread, for the last picture
};

/// An array on the graphics card. Made and used with the context current.
class GlBuffer {
 public:
  template <class Item>
  void upload(Gl& gl, DrawStatistics& statistics, GLenum target, const std::vector<Item>& items) {
    if (name_ == 0) gl.glGenBuffers(1, &name_);
    const auto bytes = static_cast<GLsizeiptr>(items.size() * sizeof(Item));
    gl.glBindBuffer(target, name_);
    // A new store each time: the card may still be reading the old one.
    gl.glBufferData(target, bytes, items.data(), GL_STREAM_DRAW);
    count_ = static_cast<GLsizei>(items.size());
    statistics.uploadedBytes += static_cast<std::uint64_t>(bytes);
    ++statistics.uploadsInAll;
  }

  GLuint name() const { return name_; }
  GLsizei count() const { return count_; }
  void destroy(Gl& gl) {
    if (name_ != 0) gl.glDeleteBuffers(1, &name_);
    name_ = 0;
    count_ = 0;
  }

 private:
  GLuint name_ = 0;
  GLsizei count_ = 0;
};

}  // namespace ui
