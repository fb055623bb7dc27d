#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>

#include "tests/support/run_program.h"
#include "ui/picture/image.h"
#include "ui/picture/video.h"

/// What players make of our films, where they are installed.
namespace {

using Colour = std::array<int, 3>;

/// Four in a row, two rows.
const std::array<Colour, 8> kCard{{{255, 0, 0},
                                   {0, 255, 0},
                                   {0, 0, 255},
                                   {128, 128, 128},
                                   {255, 255, 255},
                                   {0, 0, 0},
                                   {200, 120, 60},
                                   {60, 90, 160}}};
/// Of limited range, 219 steps for 255, and of what a codec gives up.
constexpr int kLevels = 2;

struct Size {
  int width, height;
};

/// Whether a program is there; says so where it is not.
bool have(const char* program, const char* what) {
  if (tests::runCommand(std::string(program) +
                        (std::string(program) == "chromium" ? " --version" : " -version"))
          .status == 0)
    return true;
  WARN(program << " is not installed: " << what << " was not tested");
  return false;
}

/// A film of two equal pictures of the card.
std::string cardFilm(const std::string& folder, const std::string& ending, const Size& size) {
  ui::Image image{size.width, size.height, {}};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const auto field = static_cast<std::size_t>(4 * x / size.width + 4 * (2 * y / size.height));
      for (const int level : kCard[field]) image.samples.push_back(static_cast<std::uint16_t>(257 * level));
    }
  }
  for (const char* number : {"0000", "0001"})
    REQUIRE(ui::writePng(folder + "/card." + number + ".png", image).ok());
  const std::string out = folder + "/film" + ending;
  REQUIRE(ui::writeVideo({.pictures = folder + "/card.%04d.png", .count = 2, .out = out}).ok());
  return out;
}

int difference(const Colour& a, const Colour& b) {
  int largest = 0;
  for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// The middles of the card's fields in the first picture of a film, as ffmpeg decodes it.
std::array<Colour, 8> decoded(const std::string& film, const Size& size) {
  const std::string raw = film + ".ppm";
  const auto answer = tests::runCommand("ffmpeg -nostdin -y -v error -i '" + film +
                                        "' -frames:v 1 -vf scale=flags=accurate_rnd+full_chroma_int "
                                        "-pix_fmt rgb24 '" +
                                        raw + "'");
  INFO(answer.errors);
  REQUIRE(answer.status == 0);
  std::ifstream stream(raw, std::ios::binary);
  std::string magic;
  std::size_t width = 0, height = 0, most = 0;
  stream >> magic >> width >> height >> most;
  stream.get();
  std::string pixels(3 * width * height, '\0');
  stream.read(pixels.data(), static_cast<std::streamsize>(pixels.size()));
  REQUIRE(stream);
  std::array<Colour, 8> fields{};
  for (std::size_t field = 0; field < fields.size(); ++field) {
    const auto x = (2 * (field % 4) + 1) * static_cast<std::size_t>(size.width) / 8;
    const auto y = (2 * (field / 4) + 1) * static_cast<std::size_t>(size.height) / 4;
    for (std::size_t c = 0; c < 3; ++c)
      fields[field][c] = static_cast<unsigned char>(pixels[3 * (y * width + x) + c]);
  }
  return fields;
}

/// The same as a browser shows them, painted as by a graphics card (findings/blue-by-the-processor.sh).
std::array<Colour, 8> shown(const std::string& film, const std::string& ending, const Size& size) {
  const bool isVideo = ending == ".mp4" || ending == ".mov" || ending == ".webm";
  const std::string type = ending == ".webm" ? "video/webm"
                           : isVideo         ? "video/mp4"
                                             : "image/" + ending.substr(1);
  const auto base64 = tests::runCommand("base64 -w0 '" + film + "'");
  const std::string page = film + ".html";
  std::ofstream(page) << "<p id=out>nothing</p><script>const e=document.createElement('"
                      << (isVideo ? "video" : "img")
                      << "');const draw=()=>{const c=document.createElement('canvas');c.width=" << size.width
                      << ";c.height=" << size.height
                      << ";const x=c.getContext('2d');x.drawImage(e,0,0);let s='read';for(let i=0;i<8;i++)"
                         "s+=' '+[...x.getImageData(Math.floor((2*(i%4)+1)*c.width/8),"
                         "Math.floor((2*Math.floor(i/4)+1)*c.height/4),1,1).data].slice(0,3).join(' ');"
                         "out.textContent=s+' .';};"
                      << (isVideo ? "e.muted=true;e.onloadeddata=()=>{e.currentTime=0.03;};e.onseeked=draw;"
                                  : "e.onload=draw;")
                      << "e.src='data:" << type << ";base64," << base64.output << "';</script>";
  const auto answer = tests::runCommand(
      "timeout 60 chromium --headless --no-sandbox --use-gl=angle --use-angle=swiftshader "
      "--enable-unsafe-swiftshader --user-data-dir='" +
      film + ".profile' --virtual-time-budget=8000 --dump-dom 'file://" + page + "'");
  const auto found = answer.output.find("read ");
  INFO(answer.output.substr(0, 400) << answer.errors);
  REQUIRE(found != std::string::npos);
  std::istringstream numbers(answer.output.substr(found + 5, 200));
  std::array<Colour, 8> fields{};
  for (Colour& colour : fields) numbers >> colour[0] >> colour[1] >> colour[2];
  return fields;
}

void checkCard(const std::array<Colour, 8>& read) {
  for (std::size_t field = 0; field < kCard.size(); ++field) {
    INFO("field " << field << ": " << read[field][0] << " " << read[field][1] << " " << read[field][2]);
    CHECK(difference(read[field], kCard[field]) <= kLevels);
  }
}

TEST_CASE("a film of any size has the colours of its pictures, and says how they are to be read") {
  if (!have("ffmpeg", "what films are like")) return;
  const std::string folder = tests::freshFolder("smithereens-film");
  for (const Size& size : {Size{1280, 720}, Size{321, 181}, Size{96, 64}}) {
    for (const std::string ending : {".mp4", ".mov", ".webm", ".gif", ".apng"}) {
      CAPTURE(size.width, ending);
      const std::string film = cardFilm(folder, ending, size);
      checkCard(decoded(film, size));
      if (ending == ".gif" || ending == ".apng") continue;
      const auto answer = tests::runCommand(
          "ffprobe -v error -show_entries stream=color_range,color_space,color_transfer,color_primaries "
          "-of csv=p=0 '" +
          film + "'");
      CHECK(answer.output == "tv,bt709,bt709,bt709\n");
    }
  }
}

TEST_CASE("a browser shows a film in the colours of its pictures") {
  if (!have("ffmpeg", "what a browser makes of films") || !have("chromium", "what it makes of films")) return;
  const std::string folder = tests::freshFolder("smithereens-film");
  const Size size{321, 181};
  for (const std::string ending : {".mp4", ".mov", ".webm", ".gif", ".webp", ".apng"}) {
    CAPTURE(ending);
    checkCard(shown(cardFilm(folder, ending, size), ending, size));
  }
}

}  // namespace
