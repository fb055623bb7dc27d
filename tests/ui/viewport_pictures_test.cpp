// Pictures of each view, compared with stored ones. SMITHEREENS_RENEW_PICTURES=1 in the environment writes
// them anew: look at each before it is kept.
#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>
#include <cmath>

#include <catch2/catch.hpp>

#include "tests/ui/viewport_examples.h"
#include "ui/theme/theme.h"
#include "ui/viewport/draw_maker.h"
#include "ui/viewport/viewport_renderer.h"

namespace {

constexpr QSize kSize(160, 120);
/// Mean difference a byte of colour. Drivers round and smooth edges in their own ways, which in pictures this
/// small comes to one or two; a colour that is wrong on a hundredth of the picture comes to more.
constexpr double kTolerance = 3.0;

bool never() {
  return false;
}

/// A context of its own, without a window.
class Easel {
 public:
  Easel() {
    surface_.create();
    REQUIRE(context_.create());
    REQUIRE(context_.makeCurrent(&surface_));
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::Depth);
    target_ = std::make_unique<QOpenGLFramebufferObject>(kSize, format);
    QString why;
    renderer_ = ui::ViewportRenderer::create(why);
    INFO(why.toStdString());
    REQUIRE(renderer_ != nullptr);
    camera_.look({-1.0, 0.0, 1.5}, 26.0, -1.15, 0.42);
  }
  ~Easel() {
    renderer_.reset();
    target_.reset();
    context_.doneCurrent();
  }

  ui::PictureFrame frame() const {
    return {camera_, kSize, 1.0, target_->handle(), ui::Theme::instance().colours(), {}};
  }
  ui::ViewportRenderer& renderer() { return *renderer_; }
  const ui::ViewCamera& camera() const { return camera_; }
  QImage paint(const ui::PictureFrame& frame) {
    renderer_->paint(frame);
    return target_->toImage().convertToFormat(QImage::Format_RGB888);
  }

 private:
  QOffscreenSurface surface_;
  QOpenGLContext context_;
  std::unique_ptr<QOpenGLFramebufferObject> target_;
  std::unique_ptr<ui::ViewportRenderer> renderer_;
  ui::ViewCamera camera_;
};

double meanDifference(const QImage& left, const QImage& right) {
  if (left.size() != right.size()) return 255.0;
  double sum = 0.0;
  for (int y = 0; y < left.height(); ++y) {
    for (int i = 0; i < 3 * left.width(); ++i)
      sum += std::abs(left.constScanLine(y)[i] - right.constScanLine(y)[i]);
  }
  return sum / (3.0 * left.width() * left.height());
}

void compareWithStored(const QImage& picture, const QString& name) {
  const QString file = QStringLiteral(SMITHEREENS_SOURCE_DIR "/tests/data/views/%1.png").arg(name);
  if (qEnvironmentVariableIsSet("SMITHEREENS_RENEW_PICTURES")) REQUIRE(picture.save(file));
  const QImage stored = QImage(file).convertToFormat(QImage::Format_RGB888);
  INFO(name.toStdString());
  CHECK(meanDifference(picture, stored) < kTolerance);
}

std::shared_ptr<const ui::DrawData> prepared(ui::DrawMaker& maker, const ui::Shown& shown,
                                             const ui::ViewSettings& settings) {
  return std::make_shared<const ui::DrawData>(maker.make(shown, settings, never));
}

struct View {
  const char* name;
  void (*choose)(ui::ViewSettings&);
};

constexpr std::array<View, 10> kViews{{
    {"surface", [](ui::ViewSettings&) {}},
    {"fragments", [](ui::ViewSettings& s) { s.colouring = ui::Colouring::fragments; }},
    {"quality", [](ui::ViewSettings& s) { s.colouring = ui::Colouring::quality; }},
    {"nodes",
     [](ui::ViewSettings& s) {
       s.surface = false;
       s.nodes = true;
     }},
    {"bonds",
     [](ui::ViewSettings& s) {
       s.surface = false;
       s.bonds = true;
     }},
    {"broken-bonds",
     [](ui::ViewSettings& s) {
       s.surface = false;
       s.bonds = s.brokenBonds = true;
     }},
    {"xray",
     [](ui::ViewSettings& s) {
       s.xray = true;
       s.bonds = true;
     }},
    {"exploded", [](ui::ViewSettings& s) { s.explode = 0.6; }},
    {"level",
     [](ui::ViewSettings& s) {
       s.surface = false;
       s.levelSurface = true;
     }},
    {"balls", [](ui::ViewSettings& s) { s.isolated = ui::IsolatedNodes::spheres; }},
}};

TEST_CASE("Every view looks as it did") {
  Easel easel;
  ui::DrawMaker maker;
  const ui::Shown shown = examples::brokenBlock();
  for (const View& view : kViews) {
    ui::ViewSettings settings;
    view.choose(settings);
    easel.renderer().show(prepared(maker, shown, settings));
    compareWithStored(easel.paint(easel.frame()), view.name);
  }
}

TEST_CASE("Both themes and the outline of what is selected look as they did") {
  Easel easel;
  ui::DrawMaker maker;
  easel.renderer().show(prepared(maker, examples::brokenBlock(), {}));
  ui::PictureFrame frame = easel.frame();
  frame.marked.outlinedParts = {0};
  compareWithStored(easel.paint(frame), "outline");
  ui::Theme::instance().apply(ui::ThemeKind::light);
  const QImage light = easel.paint(easel.frame());
  ui::Theme::instance().apply(ui::ThemeKind::dark);
  compareWithStored(light, "light");
}

TEST_CASE("Views differ from one another") {
  Easel easel;
  ui::DrawMaker maker;
  const ui::Shown shown = examples::brokenBlock();
  std::vector<QImage> pictures;
  for (const View& view : kViews) {
    ui::ViewSettings settings;
    view.choose(settings);
    easel.renderer().show(prepared(maker, shown, settings));
    pictures.push_back(easel.paint(easel.frame()));
    for (std::size_t i = 0; i + 1 < pictures.size(); ++i) {
      INFO(kViews[i].name << " and " << view.name);
      CHECK(pictures[i] != pictures.back());
    }
  }
}

TEST_CASE("What did not change is not uploaded again") {
  Easel easel;
  ui::DrawMaker maker;
  ui::Shown shown = examples::brokenBlock();
  easel.renderer().show(prepared(maker, shown, {}));
  easel.paint(easel.frame());
  const std::uint64_t before = easel.renderer().statistics().uploadsInAll;

  easel.renderer().show(prepared(maker, shown, {}));
  easel.paint(easel.frame());
  CHECK(easel.renderer().statistics().uploadsInAll == before);
  CHECK(easel.renderer().statistics().uploadedBytes == 0);

  // What moves without breaking: positions and normals, and nothing of what hangs together.
  sim::Snapshot later = *shown.moment;
  for (sim::Vec3& position : later.positions) position.z() += 1.0;
  shown.moment = std::make_shared<const sim::Snapshot>(std::move(later));
  const auto data = prepared(maker, shown, {});
  easel.renderer().show(data);
  CHECK(easel.renderer().statistics().uploadsInAll == before + 2);
  CHECK(easel.renderer().statistics().uploadedBytes ==
        16 * data->motion->positions.size() + 4 * data->motion->normals.size());
}

TEST_CASE("A point of the picture is found to be the face, ball or bond that is seen there") {
  Easel easel;
  ui::DrawMaker maker;
  const ui::Shown shown = examples::brokenBlock();
  const auto at = [&](const sim::Vec3& point) { return *easel.camera().project(point, kSize); };

  easel.renderer().show(prepared(maker, shown, {}));
  const ui::PickedThing ball = easel.renderer().pick(easel.frame(), at({-6.0, 0.0, 1.5}), 3.0);
  CHECK(ball.kind == ui::Pick::Kind::collider);
  CHECK(ball.index == 1);
  CHECK((ball.point - sim::Vec3(-6.0, 0.0, 1.5)).norm() == Approx(1.5).margin(0.05));
  const ui::PickedThing floor = easel.renderer().pick(easel.frame(), at({-2.0, -5.0, 0.0}), 3.0);
  CHECK(floor.kind == ui::Pick::Kind::collider);
  CHECK(floor.index == 0);
  const ui::PickedThing face = easel.renderer().pick(easel.frame(), at({-2.5, -2.0, 1.5}), 3.0);
  CHECK(face.kind == ui::Pick::Kind::part);
  CHECK(face.point.y() == Approx(-2.0).margin(0.02));
  CHECK((face.normal + sim::Vec3::UnitY()).norm() < 0.1);
  // The floor goes on to the corner of the picture, and beyond the picture there is nothing.
  CHECK(easel.renderer().pick(easel.frame(), {2.0, 2.0}, 3.0).index == 0);
  CHECK(easel.renderer().pick(easel.frame(), {-20.0, 2.0}, 3.0).kind == ui::Pick::Kind::nothing);

  ui::ViewSettings nodes;
  nodes.surface = false;
  nodes.nodes = true;
  easel.renderer().show(prepared(maker, shown, nodes));
  const ui::PickedThing node = easel.renderer().pick(easel.frame(), at(shown.moment->positions[0]), 3.0);
  CHECK(node.kind == ui::Pick::Kind::node);
  CHECK(node.index == 0);

  ui::ViewSettings bonds;
  bonds.surface = false;
  bonds.bonds = true;
  const auto data = prepared(maker, shown, bonds);
  easel.renderer().show(data);
  // Nothing is before the bond along the nearest lower edge.
  sim::BondIndex edge = 0;
  double least = 1e9;
  for (sim::BondIndex bond = 0; bond < data->lattice->bonds.size(); ++bond) {
    const auto& ends = data->lattice->bonds[bond];
    const sim::Vec3 middle = 0.5 * (shown.network->positions[ends.a] + shown.network->positions[ends.b]);
    const double distance = (middle - sim::Vec3(-2.5, -2.0, 3.0)).norm();
    if (distance < least) {
      least = distance;
      edge = bond;
    }
  }
  const auto& ends = data->lattice->bonds[edge];
  const sim::Vec3 middle = 0.5 * (shown.moment->positions[ends.a] + shown.moment->positions[ends.b]);
  const ui::PickedThing bond = easel.renderer().pick(easel.frame(), at(middle), 3.0);
  CHECK(bond.kind == ui::Pick::Kind::bond);
  CHECK(bond.index == edge);
}

}  // namespace
