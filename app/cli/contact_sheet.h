#pragma once

#include <cstddef>

#include "ui/picture/image.h"

namespace app {

/// Pictures of one size in rows, each with a number in its corner.
class ContactSheet {
 public:
  ContactSheet(int pictureWidth, int pictureHeight, std::size_t columns, std::size_t pictures);

  /// Puts the picture in its place, and the number on it.
  void place(std::size_t index, const ui::Image& picture);
  /// Leaves the place grey, but for the number: there is no picture.
  void leave(std::size_t index) { number(index); }

  const ui::Image& image() const { return sheet_; }

 private:
  void number(std::size_t index);
  void digit(int left, int top, unsigned which);
  void fill(int x, int y, std::uint16_t level);
  int leftOf(std::size_t index) const;
  int topOf(std::size_t index) const;

  int width_, height_;
  std::size_t columns_;
  ui::Image sheet_;
};

}  // namespace app
