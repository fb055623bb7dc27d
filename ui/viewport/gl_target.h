#pragma once

#include <QSize>
#include <vector>

#include "ui/viewport/gl.h"

namespace ui {

/// A picture that is drawn to read it, not to show it: textures of given formats, and a depth buffer.
class GlTarget {
 public:
  struct Format {
    GLenum stored;
    GLenum format;
    GLenum type;
  };
  explicit GlTarget(std::vector<Format> formats) : formats_(std::move(formats)) {}

  /// Binds it, as large as that; makes it anew where it has another size.
  void bind(Gl& gl, const QSize& size) {
    if (size != size_) remake(gl, size);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, buffer_);
    gl.glViewport(0, 0, size.width(), size.height());
  }

  GLuint texture(std::size_t index) const { return textures_[index]; }

  void destroy(Gl& gl) {
    if (buffer_ == 0) return;
    gl.glDeleteFramebuffers(1, &buffer_);
    gl.glDeleteRenderbuffers(1, &depth_);
    gl.glDeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
    textures_.clear();
    buffer_ = 0;
    size_ = {};
  }

 private:
  void remake(Gl& gl, const QSize& size) {
    destroy(gl);
    size_ = size;
    gl.glGenFramebuffers(1, &buffer_);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, buffer_);
    textures_.resize(formats_.size());
    gl.glGenTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
    std::vector<GLenum> attachments;
    for (std::size_t i = 0; i < formats_.size(); ++i) {
      gl.glBindTexture(GL_TEXTURE_2D, textures_[i]);
      gl.glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(formats_[i].stored), size.width(), size.height(),
                      0, formats_[i].format, formats_[i].type, nullptr);
      gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
      gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
      gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
      attachments.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
      gl.glFramebufferTexture2D(GL_FRAMEBUFFER, attachments.back(), GL_TEXTURE_2D, textures_[i], 0);
    }
    gl.glDrawBuffers(static_cast<GLsizei>(attachments.size()), attachments.data());
    gl.glGenRenderbuffers(1, &depth_);
    gl.glBindRenderbuffer(GL_RENDERBUFFER, depth_);
    gl.glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size.width(), size.height());
    gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  }

  std::vector<Format> formats_;
  QSize size_;
  GLuint buffer_ = 0;
  GLuint depth_ = 0;
  std::vector<GLuint> textures_;
};

}  // namespace ui
