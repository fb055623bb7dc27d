#include "ui/picture/picture.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <utility>

#include <tbb/task_arena.h>

#include "sim/base/bytes.h"
#include "sim/base/parallel.h"
#include "ui/picture/lens.h"
#include "ui/picture/path_tracer.h"

namespace ui {

namespace {

constexpr int kTile = 16;
constexpr int kLargestSide = 8192;
constexpr int kMostSamples = 65536;

/// Radiance above this is rolled off, so that a white glaze in full light keeps its form.
constexpr float kShoulder = 0.6F;

std::uint16_t shown(float radiance) {
  constexpr float kRoom = 1.0F - kShoulder;
  const float rolled =
      radiance <= kShoulder ? radiance : 1.0F - kRoom * std::exp(-(radiance - kShoulder) / kRoom);
  const float encoded = srgbFromLinear(std::clamp(rolled, 0.0F, 1.0F));
  return static_cast<std::uint16_t>(std::lround(encoded * 65535.0F));
}

std::vector<TracedScene::Plane> floorsOf(const PictureScene& scene) {
  std::vector<TracedScene::Plane> floors;
  const modeling::GroundKind kind = scene.style.ground.kind;
  if (kind == modeling::GroundKind::none) return floors;
  for (const sim::Collider& collider : scene.colliders) {
    if (!collider.visible || !collider.isFloor()) continue;
    const sim::Vec3 normal = collider.rotation * sim::Vec3::UnitZ();
    const double offset = normal.dot(collider.position - scene.subject.center());
    floors.push_back({normal.cast<float>(), static_cast<float>(offset)});
  }
  if (floors.empty() && kind != modeling::GroundKind::studio) {
    const double lowest = scene.subject.min().z() - scene.subject.center().z();
    floors.push_back({Vec3f::UnitZ(), static_cast<float>(lowest)});
  }
  return floors;
}

/// At the head of what is kept.
constexpr std::uint64_t kKeptMark = 0x5430736572757470ULL;

}  // namespace

class PictureRun::Renderer {
 public:
  Renderer(const TracedScene& traced, const PictureScene& scene, const PictureSettings& settings)
      : studio_(arrangeStudio(scene.camera, scene.subject, scene.style, scene.environment)),
        tracer_(traced, studio_),
        lens_(scene.camera, scene.subject.center(), settings.width, settings.height),
        settings_(settings),
        tilesAcross_((settings.width + kTile - 1) / kTile),
        samplesOfTile_(static_cast<std::size_t>(tilesAcross_ * ((settings.height + kTile - 1) / kTile)), 0) {
    film_.width = settings.width;
    film_.height = settings.height;
    film_.pixels.resize(static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height));
  }

  bool advanceTo(int samples) {
    samples = std::min(samples, settings_.samples);
    cancelled_ = false;
    inArena([&] {
      sim::parallelFor(samplesOfTile_.size(), [&](std::size_t tile) {
        if (cancelled_ || samplesOfTile_[tile] >= samples) return;
        drawTile(static_cast<int>(tile), samples);
        tell(samples - std::exchange(samplesOfTile_[tile], samples));
      });
    });
    return !cancelled_;
  }

  int samples() const { return *std::min_element(samplesOfTile_.begin(), samplesOfTile_.end()); }

  Image image() const {
    Film film = film_;
    for (FilmPixel& pixel : film.pixels) pixel.finish();
    inArena([&] { smoothIndirect(film); });
    Image image{.width = film.width, .height = film.height, .samples = {}};
    image.samples.reserve(3 * film.pixels.size());
    for (const FilmPixel& pixel : film.pixels) {
      const Light light = pixel.mean.light();
      for (int channel = 0; channel < 3; ++channel) image.samples.push_back(shown(light[channel]));
    }
    return image;
  }

  std::vector<std::byte> kept(const std::string& of) const {
    sim::ByteWriter out;
    out.put(kKeptMark);
    out.putString(of);
    out.put(film_.width);
    out.put(film_.height);
    out.put(settings_.seed);
    out.putVector(samplesOfTile_);
    for (const FilmPixel& pixel : film_.pixels) out.put(pixel.sums());
    return std::move(out).take();
  }

  bool goOnFrom(std::span<const std::byte> bytes, const std::string& of) {
    sim::ByteReader in(bytes);
    std::uint64_t mark = 0;
    std::string name;
    int width = 0, height = 0;
    std::uint32_t seed = 0;
    std::vector<int> tiles;
    in.read(mark);
    in.readString(name);
    in.read(width);
    in.read(height);
    in.read(seed);
    in.readVector(tiles);
    if (!in.ok() || mark != kKeptMark || name != of || width != film_.width || height != film_.height ||
        seed != settings_.seed || tiles.size() != samplesOfTile_.size() ||
        in.remaining() != film_.pixels.size() * sizeof(float) * FilmPixel::kSums)
      return false;
    if (std::any_of(tiles.begin(), tiles.end(), [](int count) { return count < 0 || count > kMostSamples; }))
      return false;
    samplesOfTile_ = tiles;
    for (FilmPixel& pixel : film_.pixels) {
      std::array<float, FilmPixel::kSums> sums{};
      in.read(sums);
      pixel.setSums(sums);
    }
    done_ = 0;
    for (const int count : samplesOfTile_) done_ += count;
    return true;
  }

 private:
  template <class Work>
  void inArena(const Work& work) const {
    const int most = tbb::this_task_arena::max_concurrency();
    tbb::task_arena arena(settings_.threads > 0 ? std::min(settings_.threads, most) : most);
    arena.execute(work);
  }

  void drawTile(int tile, int samples) {
    const int left = tile % tilesAcross_ * kTile;
    const int top = tile / tilesAcross_ * kTile;
    for (int y = top; y < std::min(top + kTile, settings_.height); ++y) {
      for (int x = left; x < std::min(left + kTile, settings_.width); ++x)
        drawPixel(x, y, samplesOfTile_[static_cast<std::size_t>(tile)], samples);
    }
  }

  void drawPixel(int x, int y, int from, int to) {
    const auto index = static_cast<std::uint32_t>(y * settings_.width + x);
    PixelSampler sampler(settings_.seed * 0x9e3779b9U + index);
    FilmPixel& pixel = film_.pixels[index];
    for (int sample = from; sample < to; ++sample) {
      sampler.startSample(static_cast<std::uint32_t>(sample));
      const auto offset = filterOffset(sampler.pair(0));
      const Lens::Ray ray = lens_.through(static_cast<float>(x) + 0.5F + offset[0],
                                          static_cast<float>(y) + 0.5F + offset[1], sampler.pair(1));
      pixel.add(tracer_.expose(ray.origin, ray.direction, sampler.pair(2)[0], sampler));
    }
  }

  void tell(int samples) {
    const std::lock_guard lock(mutex_);
    done_ += samples;
    if (!settings_.progress || cancelled_) return;
    const double all = static_cast<double>(samplesOfTile_.size()) * settings_.samples;
    if (!settings_.progress(static_cast<double>(done_) / all)) cancelled_ = true;
  }

  Studio studio_;
  PathTracer tracer_;
  Lens lens_;
  Film film_;
  PictureSettings settings_;
  int tilesAcross_;
  std::vector<int> samplesOfTile_;
  std::mutex mutex_;
  std::int64_t done_ = 0;
  std::atomic<bool> cancelled_ = false;
};

sim::Result<std::unique_ptr<PictureRun>> PictureRun::create(const PictureScene& scene,
                                                            const PictureSettings& settings) {
  const auto inRange = [](int value, int largest) { return value >= 1 && value <= largest; };
  if (!inRange(settings.width, kLargestSide) || !inRange(settings.height, kLargestSide)) {
    return sim::Problem{"", "a picture has 1 to 8192 pixels a side", "give a size such as 1280x720"};
  }
  if (!inRange(settings.samples, kMostSamples)) {
    return sim::Problem{"", "a pixel takes 1 to 65536 samples", "give a number such as 48"};
  }
  auto traced = TracedScene::create(drawMesh(scene), floorsOf(scene));
  if (!traced) return traced.problem();
  std::unique_ptr<PictureRun> run(new PictureRun);
  run->traced_ = std::move(*traced);
  run->renderer_ = std::make_unique<Renderer>(*run->traced_, scene, settings);
  return run;
}

PictureRun::~PictureRun() = default;

bool PictureRun::advanceTo(int samples) {
  return renderer_->advanceTo(samples);
}

int PictureRun::samples() const {
  return renderer_->samples();
}

Image PictureRun::image() const {
  return renderer_->image();
}

std::vector<std::byte> PictureRun::kept(const std::string& of) const {
  return renderer_->kept(of);
}

sim::Status PictureRun::goOnFrom(std::span<const std::byte> kept, const std::string& of) {
  if (renderer_->goOnFrom(kept, of)) return sim::Done{};
  return sim::Problem{"", "what was kept is of another picture, or damaged", "draw it from the start"};
}

sim::Result<Image> renderPicture(const PictureScene& scene, const PictureSettings& settings) {
  const auto run = PictureRun::create(scene, settings);
  if (!run) return run.problem();
  if (!(*run)->advanceTo(settings.samples)) return sim::Problem{"", "the picture was cancelled", ""};
  return (*run)->image();
}

}  // namespace ui
