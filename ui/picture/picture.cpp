#include "ui/picture/picture.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include <tbb/task_arena.h>

#include "sim/base/parallel.h"
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

/// Rays through pixels, in coordinates relative to the middle of the subject.
struct Lens {
  Vec3f origin;
  Vec3f forward;
  Vec3f acrossPixel;  ///< at distance 1
  Vec3f downPixel;
  int width;
  int height;

  Lens(const Camera& camera, const sim::Vec3& middle, int pixelWidth, int pixelHeight)
      : origin((camera.position - middle).cast<float>()), width(pixelWidth), height(pixelHeight) {
    sim::Vec3 ahead = camera.target - camera.position;
    ahead = ahead.norm() > 0.0 ? sim::Vec3(ahead.normalized()) : -sim::Vec3::UnitZ();
    const sim::Vec3 level = ahead.cross(sim::Vec3::UnitZ());
    const sim::Vec3 right = level.norm() > 1e-9 ? sim::Vec3(level.normalized()) : sim::Vec3::UnitX();
    const double pixel = 2.0 * std::tan(camera.verticalFieldOfView / 2.0) / pixelHeight;
    forward = ahead.cast<float>();
    acrossPixel = (pixel * right).cast<float>();
    downPixel = (pixel * ahead.cross(right)).cast<float>();
  }

  Vec3f direction(float x, float y) const {
    const float across = x - 0.5F * static_cast<float>(width);
    const float down = y - 0.5F * static_cast<float>(height);
    return (forward + across * acrossPixel + down * downPixel).normalized();
  }
};

class Renderer {
 public:
  Renderer(const TracedScene& traced, const PictureScene& scene, const PictureSettings& settings)
      : tracer_(traced, studio_),
        lens_(scene.camera, scene.subject.center(), settings.width, settings.height),
        settings_(settings),
        studio_(arrangeStudio(scene.camera, scene.subject)) {
    film_.width = settings.width;
    film_.height = settings.height;
    film_.pixels.resize(static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height));
  }

  sim::Result<Image> render() {
    const int tilesAcross = (settings_.width + kTile - 1) / kTile;
    const int tileCount = tilesAcross * ((settings_.height + kTile - 1) / kTile);
    const int most = tbb::this_task_arena::max_concurrency();
    tbb::task_arena arena(settings_.threads > 0 ? std::min(settings_.threads, most) : most);
    arena.execute([&] {
      sim::parallelFor(static_cast<std::size_t>(tileCount), [&](std::size_t index) {
        if (cancelled_) return;
        const int tile = static_cast<int>(index);
        drawTile((tile % tilesAcross) * kTile, (tile / tilesAcross) * kTile);
        tell(tileCount);
      });
      if (!cancelled_) smoothIndirect(film_);
    });
    if (cancelled_) return sim::Problem{"", "the picture was cancelled", ""};
    return developed();
  }

 private:
  void drawTile(int left, int top) {
    for (int y = top; y < std::min(top + kTile, settings_.height); ++y) {
      for (int x = left; x < std::min(left + kTile, settings_.width); ++x) drawPixel(x, y);
    }
  }

  void drawPixel(int x, int y) {
    const auto index = static_cast<std::uint32_t>(y * settings_.width + x);
    PixelSampler sampler(settings_.seed * 0x9e3779b9U + index);
    FilmPixel& pixel = film_.pixels[index];
    for (int sample = 0; sample < settings_.samples; ++sample) {
      sampler.startSample(static_cast<std::uint32_t>(sample));
      const auto offset = filterOffset(sampler.pair(0));
      const Vec3f direction =
          lens_.direction(static_cast<float>(x) + 0.5F + offset[0], static_cast<float>(y) + 0.5F + offset[1]);
      pixel.add(tracer_.expose(lens_.origin, direction, sampler));
    }
    pixel.finish();
  }

  Image developed() const {
    Image image{.width = film_.width, .height = film_.height, .samples = {}};
    image.samples.reserve(3 * film_.pixels.size());
    for (const FilmPixel& pixel : film_.pixels) {
      const Light light = pixel.mean.light();
      for (int channel = 0; channel < 3; ++channel) image.samples.push_back(shown(light[channel]));
    }
    return image;
  }

  void tell(int tileCount) {
    if (!settings_.progress) return;
    const std::lock_guard lock(mutex_);
    if (!cancelled_ && !settings_.progress(static_cast<double>(++tilesDone_) / tileCount)) cancelled_ = true;
  }

  PathTracer tracer_;
  Lens lens_;
  Film film_;
  const PictureSettings& settings_;
  Studio studio_;
  std::mutex mutex_;
  int tilesDone_ = 0;
  std::atomic<bool> cancelled_ = false;
};

std::vector<TracedScene::Plane> floorsOf(const PictureScene& scene) {
  std::vector<TracedScene::Plane> floors;
  for (const sim::Collider& collider : scene.colliders) {
    if (!collider.visible || collider.shape != sim::ColliderShape::floor) continue;
    const sim::Vec3 normal = collider.rotation * sim::Vec3::UnitZ();
    const double offset = normal.dot(collider.position - scene.subject.center());
    floors.push_back({normal.cast<float>(), static_cast<float>(offset)});
  }
  return floors;
}

}  // namespace

sim::Result<Image> renderPicture(const PictureScene& scene, const PictureSettings& settings) {
  const auto inRange = [](int value, int largest) { return value >= 1 && value <= largest; };
  if (!inRange(settings.width, kLargestSide) || !inRange(settings.height, kLargestSide)) {
    return sim::Problem{"", "a picture has 1 to 8192 pixels a side", "give a size such as 1280x720"};
  }
  if (!inRange(settings.samples, kMostSamples)) {
    return sim::Problem{"", "a pixel takes 1 to 65536 samples", "give a number such as 48"};
  }
  auto traced = TracedScene::create(drawMesh(scene), floorsOf(scene));
  if (!traced) return traced.problem();
  return Renderer(**traced, scene, settings).render();
}

}  // namespace ui
