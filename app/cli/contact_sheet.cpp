#include "app/cli/contact_sheet.h"

#include <algorithm>
#include <array>
#include <string>

namespace app {

namespace {

constexpr int kGap = 4;
constexpr std::uint16_t kGround = 0x5000;
constexpr std::uint16_t kInk = 0xffff;
constexpr std::uint16_t kShadow = 0x1000;
/// Pixels a dot of a digit is wide.
constexpr int kDot = 2;

/// Three dots by five, row by row from the top, the leftmost the highest bit.
constexpr std::array<std::array<unsigned, 5>, 10> kDigits{{{7, 5, 5, 5, 7},
                                                           {2, 6, 2, 2, 7},
                                                           {7, 1, 7, 4, 7},
                                                           {7, 1, 7, 1, 7},
                                                           {5, 5, 7, 1, 1},
                                                           {7, 4, 7, 1, 7},
                                                           {7, 4, 7, 5, 7},
                                                           {7, 1, 2, 2, 2},
                                                           {7, 5, 7, 5, 7},
                                                           {7, 5, 7, 1, 7}}};

}  // namespace

ContactSheet::ContactSheet(int pictureWidth, int pictureHeight, std::size_t columns, std::size_t pictures)
    : width_(pictureWidth), height_(pictureHeight), columns_(columns) {
  const std::size_t rows = (pictures + columns - 1) / columns;
  sheet_.width = static_cast<int>(columns) * (width_ + kGap) + kGap;
  sheet_.height = static_cast<int>(rows) * (height_ + kGap) + kGap;
  sheet_.samples.assign(3 * static_cast<std::size_t>(sheet_.width) * static_cast<std::size_t>(sheet_.height),
                        kGround);
}

int ContactSheet::leftOf(std::size_t index) const {
  return kGap + static_cast<int>(index % columns_) * (width_ + kGap);
}

int ContactSheet::topOf(std::size_t index) const {
  return kGap + static_cast<int>(index / columns_) * (height_ + kGap);
}

void ContactSheet::place(std::size_t index, const ui::Image& picture) {
  const auto across = 3 * static_cast<std::ptrdiff_t>(std::min(width_, picture.width));
  for (int y = 0; y < std::min(height_, picture.height); ++y) {
    const auto from = picture.samples.begin() + 3 * static_cast<std::ptrdiff_t>(y) * picture.width;
    const auto to = sheet_.samples.begin() +
                    3 * (static_cast<std::ptrdiff_t>(topOf(index) + y) * sheet_.width + leftOf(index));
    std::copy(from, from + across, to);
  }
  number(index);
}

void ContactSheet::fill(int x, int y, std::uint16_t level) {
  if (x < 0 || y < 0 || x >= sheet_.width || y >= sheet_.height) return;
  const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(sheet_.width) +
                       static_cast<std::size_t>(x));
  std::fill_n(sheet_.samples.begin() + static_cast<std::ptrdiff_t>(at), 3, level);
}

void ContactSheet::digit(int left, int top, unsigned which) {
  for (int row = 0; row < 5 * kDot; ++row) {
    for (int column = 0; column < 3 * kDot; ++column) {
      const unsigned dots = kDigits[which][static_cast<std::size_t>(row / kDot)];
      if (((dots >> (2 - column / kDot)) & 1U) == 0) continue;
      fill(left + column + 1, top + row + 1, kShadow);
      fill(left + column, top + row, kInk);
    }
  }
}

void ContactSheet::number(std::size_t index) {
  int left = leftOf(index) + 2 * kDot;
  for (const char letter : std::to_string(index)) {
    digit(left, topOf(index) + 2 * kDot, static_cast<unsigned>(letter - '0'));
    left += 4 * kDot;
  }
}

}  // namespace app
