#include "ui/picture/exr_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <exception>
#include <map>
#include <string>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>

namespace ui {

namespace {

sim::Problem damaged() {
  return {"", "this OpenEXR image is damaged or cut off", "open it in an image editor and save it again"};
}

std::string inSmall(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

/// The three channels of a layer of one part; one of luminance stands for all three.
struct Layer {
  int part = 0;
  std::string name;  ///< "" where channels have no prefix
  std::array<std::string, 3> channels;
};

struct Contents {
  std::vector<Layer> layers;
  bool chroma = false;       ///< the first part has luminance and chroma, which have to be put together
  std::string channelNames;  ///< for messages
};

bool isSampledWhole(const Imf::Channel& channel) {
  return channel.xSampling == 1 && channel.ySampling == 1;
}

void addLayers(int part, const Imf::ChannelList& list, Contents& contents) {
  std::map<std::string, std::map<char, std::string>> byLayer;
  for (auto channel = list.begin(); channel != list.end(); ++channel) {
    const std::string name = channel.name();
    contents.channelNames.append(contents.channelNames.empty() ? "" : ", ").append(name);
    if (part == 0 && (name == "RY" || name == "BY")) contents.chroma = true;
    const std::size_t point = name.rfind('.');
    const std::string last = inSmall(point == std::string::npos ? name : name.substr(point + 1));
    if (last.size() == 1 && isSampledWhole(channel.channel()))
      byLayer[point == std::string::npos ? "" : name.substr(0, point)].emplace(last[0], name);
  }
  for (const auto& [name, channels] : byLayer) {
    if (channels.contains('r') && channels.contains('g') && channels.contains('b'))
      contents.layers.push_back({part, name, {channels.at('r'), channels.at('g'), channels.at('b')}});
    else if (channels.contains('y') && !channels.contains('x'))
      contents.layers.push_back({part, name, {channels.at('y'), channels.at('y'), channels.at('y')}});
  }
}

Contents contentsOf(const Imf::MultiPartInputFile& file) {
  Contents contents;
  for (int part = 0; part < file.parts(); ++part) {
    const Imf::Header& header = file.header(part);
    const bool deep = header.hasType() && !Imf::isImage(header.type());
    if (!deep) addLayers(part, header.channels(), contents);
  }
  return contents;
}

/// Lower is better.
int rankOf(const Layer& layer) {
  if (layer.name.empty()) return 0;
  const std::string name = inSmall(layer.name);
  for (const char* const usual : {"combined", "beauty", "rgba"}) {
    if (name.find(usual) != std::string::npos) return 1;
  }
  return layer.channels[0] != layer.channels[1] ? 2 : 3;  // colours before greys, which may be depths
}

sim::Status readLayer(Imf::MultiPartInputFile& file, const Layer& layer, const ExrTaker& taker) {
  Imf::InputPart part(file, layer.part);
  const auto box = part.header().dataWindow();
  const std::int64_t width = std::int64_t{box.max.x} - box.min.x + 1;
  const std::int64_t height = std::int64_t{box.max.y} - box.min.y + 1;
  if (auto problem = taker.start(width, height)) return *problem;
  std::array<std::vector<float>, 3> numbers;
  for (auto& channel : numbers) channel.resize(static_cast<std::size_t>(width));
  std::vector<Light> row(static_cast<std::size_t>(width));
  Imf::FrameBuffer buffer;
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0 && layer.channels[i] == layer.channels[0]) continue;
    // One row stands for all, whatever its number.
    auto* const base = reinterpret_cast<char*>(numbers[i].data() - box.min.x);
    buffer.insert(layer.channels[i], Imf::Slice(Imf::FLOAT, base, sizeof(float), 0));
  }
  part.setFrameBuffer(buffer);
  const bool grey = layer.channels[0] == layer.channels[1];
  for (int y = box.min.y; y <= box.max.y; ++y) {
    part.readPixels(y);
    for (std::size_t x = 0; x < row.size(); ++x)
      row[x] = {numbers[0][x], numbers[grey ? 0 : 1][x], numbers[grey ? 0 : 2][x]};
    taker.row(row);
  }
  return sim::Done{};
}

/// The library puts luminance and chroma together.
sim::Status readChroma(const std::filesystem::path& path, const ExrTaker& taker) {
  Imf::RgbaInputFile file(path.c_str());
  const auto box = file.dataWindow();
  const std::int64_t width = std::int64_t{box.max.x} - box.min.x + 1;
  const std::int64_t height = std::int64_t{box.max.y} - box.min.y + 1;
  if (auto problem = taker.start(width, height)) return *problem;
  std::vector<Imf::Rgba> read(static_cast<std::size_t>(width));
  std::vector<Light> row(read.size());
  for (int y = box.min.y; y <= box.max.y; ++y) {
    file.setFrameBuffer(read.data() - box.min.x, 1, 0);
    file.readPixels(y);
    std::transform(read.begin(), read.end(), row.begin(),
                   [](const Imf::Rgba& of) { return Light(of.r, of.g, of.b); });
    taker.row(row);
  }
  return sim::Done{};
}

}  // namespace

sim::Status readExrColours(const std::filesystem::path& path, const ExrTaker& taker) {
  try {
    Imf::MultiPartInputFile file(path.c_str());
    const Contents contents = contentsOf(file);
    if (contents.chroma) return readChroma(path, taker);
    const auto best =
        std::min_element(contents.layers.begin(), contents.layers.end(),
                         [](const Layer& left, const Layer& right) { return rankOf(left) < rankOf(right); });
    if (best != contents.layers.end()) return readLayer(file, *best, taker);
    return sim::Problem{"",
                        "no channels of this OpenEXR image are colours; it has " +
                            (contents.channelNames.empty() ? "none" : contents.channelNames),
                        "save it with the channels R, G and B, or with a layer of them"};
  } catch (const std::exception&) {
    return damaged();
  }
}

}  // namespace ui
