#include "modeling/text/printable.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "sim/base/random.h"

namespace {

using modeling::printable;

TEST_CASE("what a terminal would obey is shown instead") {
  CHECK(printable("a cup") == "a cup");
  CHECK(printable("Tasse für Émile, 湯呑み, 🫖") == "Tasse für Émile, 湯呑み, 🫖");
  CHECK(printable("\x1b[2J\x07") == "\\x1b[2J\\x07");
  CHECK(printable("one\ntwo\r\tthree\x7f") == "one\\ntwo\\x0d\\tthree\\x7f");
  CHECK(printable("\xc2\x9b"
                  "31m") == "\\x9b31m");  // the same as ESC [, in one letter
  CHECK(printable("gnp.\xe2\x80\xae"
                  "cup") == "gnp.\\u202ecup");  // writes backwards from there on
  CHECK(printable("a\xe2\x80\x8b"
                  "b") == "a\\u200bb");
  CHECK(printable(std::string("a\0b", 3)) == "a\\x00b");
}

TEST_CASE("what is no UTF-8 is shown byte by byte") {
  CHECK(printable("\xff\xfe") == "\\xff\\xfe");
  CHECK(printable("\xc0\x9b") == "\\xc0\\x9b");                    // a longer form of ESC
  CHECK(printable("\xe2\x80") == "\\xe2\\x80");                    // cut off
  CHECK(printable("\xed\xa0\x80") == "\\xed\\xa0\\x80");           // half of a pair of UTF-16
  CHECK(printable("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");  // beyond Unicode
}

TEST_CASE("nothing that is printed can be obeyed, whatever the bytes") {
  std::uint64_t draw = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::string text;
    for (int i = 0; i < 40; ++i)
      text += static_cast<char>(static_cast<unsigned char>(sim::uniformAt(14, draw++) * 256.0));
    const std::string shown = printable(text);
    CHECK(std::none_of(shown.begin(), shown.end(),
                       [](unsigned char byte) { return byte < 0x20 || byte == 0x7f; }));
    CHECK(printable(shown) == shown);
  }
}

}  // namespace
