// What a frame of the window costs: fetching it from a take's file, making of it what is drawn, and drawing
// it. "CPU" is the processor's time of the thread that waits, "process" that of all threads, those among them
// that stand in for a graphics card where there is none.
#include <QApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>
#include <ctime>
#include <iostream>
#include <random>

#include <benchmark/benchmark.h>

#include "ui/session/footage.h"
#include "ui/theme/theme.h"
#include "ui/viewport/draw_maker.h"
#include "ui/viewport/viewport_renderer.h"

namespace {

constexpr QSize kSize(1280, 800);
/// Drawn without a graphics card each takes a quarter of a second.
constexpr int kPictures = 30;

struct Film {
  std::shared_ptr<ui::Footage> footage;
  std::shared_ptr<const modeling::Scene> scene;
  std::vector<sim::SnapshotPointer> frames;

  ui::Shown shown(std::size_t frame) const {
    ui::Shown shown;
    shown.network = footage->network();
    shown.scene = scene;
    shown.moment = frames[frame % frames.size()];
    return shown;
  }
};

/// All of a take, in memory. The program ends where it cannot be read.
Film filmOf(const char* file) {
  const auto orEnd = [](auto result) {
    if (result) return std::move(result).value();
    std::cerr << result.problem().what << '\n';
    std::exit(2);
  };
  Film film;
  film.footage = orEnd(ui::Footage::open(file));
  film.scene = film.footage->scene();
  for (std::size_t frame = 0; frame < film.footage->frameCount(); ++frame)
    film.frames.push_back(orEnd(film.footage->frame(frame)));
  return film;
}

/// Something to draw on, without a window, its edges smoothed as the window's are.
class Easel {
 public:
  Easel() {
    surface_.create();
    context_.create();
    context_.makeCurrent(&surface_);
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::Depth);
    format.setSamples(4);
    target_ = std::make_unique<QOpenGLFramebufferObject>(kSize, format);
    QString why;
    renderer_ = ui::ViewportRenderer::create(why);
    if (renderer_) return;
    std::cerr << why.toStdString() << '\n';
    std::exit(2);
  }

  std::string driver() const {
    return reinterpret_cast<const char*>(context_.functions()->glGetString(GL_RENDERER));
  }
  void frame(const Eigen::AlignedBox3d& box) { camera_.frame(box, kSize); }
  std::uint64_t paint(const std::shared_ptr<const ui::DrawData>& data) {
    renderer_->show(data);
    renderer_->paint({camera_, kSize, 1.0, target_->handle(), ui::Theme::instance().colours(), {}});
    return renderer_->statistics().uploadedBytes;
  }
  void awaitCard() { context_.functions()->glFinish(); }

 private:
  QOffscreenSurface surface_;
  QOpenGLContext context_;
  std::unique_ptr<QOpenGLFramebufferObject> target_;
  std::unique_ptr<ui::ViewportRenderer> renderer_;
  ui::ViewCamera camera_;
};

double processSeconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

bool never() {
  return false;
}

void fetch(benchmark::State& state, const Film& film) {
  std::mt19937 random(1);
  for (auto _ : state) {
    // The frames in memory are another footage's: this one reads its file.
    benchmark::DoNotOptimize(film.footage->frame(random() % film.frames.size()));
  }
}

void prepare(benchmark::State& state, const Film& film, const ui::ViewSettings& settings) {
  ui::DrawMaker maker;
  std::size_t frame = 0;
  for (auto _ : state) benchmark::DoNotOptimize(maker.make(film.shown(frame++), settings, never));
}

void paint(benchmark::State& state, const Film& film, Easel& easel, const ui::ViewSettings& settings) {
  ui::DrawMaker maker;
  std::size_t frame = 0;
  double process = 0.0;
  double uploaded = 0.0;
  for (auto _ : state) {
    state.PauseTiming();
    const auto data = std::make_shared<const ui::DrawData>(maker.make(film.shown(frame++), settings, never));
    easel.frame(data->box);
    easel.awaitCard();
    const double start = processSeconds();
    state.ResumeTiming();
    uploaded += static_cast<double>(easel.paint(data));
    state.PauseTiming();
    easel.awaitCard();
    process += processSeconds() - start;
    state.ResumeTiming();
  }
  state.counters["process_ms"] = benchmark::Counter(1e3 * process, benchmark::Counter::kAvgIterations);
  state.counters["uploaded_kB"] = benchmark::Counter(1e-3 * uploaded, benchmark::Counter::kAvgIterations);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  ui::ViewportRenderer::askForContexts();
  QApplication application(argc, argv);
  if (argc != 2) {
    std::cerr << "usage: bench-window [BENCHMARK-OPTION...] TAKE\n";
    return 2;
  }
  const Film film = filmOf(argv[1]);
  Easel easel;
  std::cout << film.footage->network()->nodeCount() << " nodes, " << film.footage->network()->bondCount()
            << " bonds, " << film.frames.size() << " frames, drawn by " << easel.driver() << '\n';

  ui::ViewSettings surface;
  ui::ViewSettings plain = surface;
  plain.shadows = plain.occlusion = false;
  ui::ViewSettings bonds = plain;
  bonds.surface = false;
  bonds.bonds = true;
  ui::ViewSettings nodes = plain;
  nodes.surface = false;
  nodes.nodes = true;
  constexpr auto kUnit = benchmark::kMillisecond;
  benchmark::RegisterBenchmark("fetch", fetch, film)->Unit(kUnit);
  for (const auto& [name, settings] : {std::pair("surface", surface), std::pair("surface, plain", plain),
                                       std::pair("bonds", bonds), std::pair("nodes", nodes)}) {
    benchmark::RegisterBenchmark((std::string("prepare ") + name).c_str(), prepare, film, settings)
        ->Unit(kUnit);
    benchmark::RegisterBenchmark((std::string("paint ") + name).c_str(), paint, std::cref(film),
                                 std::ref(easel), settings)
        ->Iterations(kPictures)
        ->Unit(kUnit);
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
