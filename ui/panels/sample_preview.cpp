#include "ui/panels/sample_preview.h"

#include <QPainter>
#include <algorithm>

#include "ui/theme/theme.h"

namespace ui {
namespace {

constexpr int kSettling = 250;      // ms
constexpr int kFrameTime = 40;      // ms
constexpr int kRestFrames = 18;     // the last picture stays a moment
constexpr double kHalfWidth = 6.0;  // cm seen to the left and right
constexpr double kBelow = 3.2;      // cm from the middle down: where the halves fall
const sim::Vec3 kLight(0.35, -0.55, 0.76);

/// Seen from the front, a little from above and from the right.
struct Projection {
  QPointF middle;
  double scale;

  QPointF operator()(const sim::Vec3& p) const {
    return middle + scale * QPointF(p.x() - 0.28 * p.y(), -(p.z() + 0.34 * p.y()));
  }
  static double depth(const sim::Vec3& p) { return p.y() + 0.28 * p.x() - 0.34 * p.z(); }
};

Projection projectionOf(const QSize& size) {
  const double scale = std::min(size.width() / (2.0 * kHalfWidth), size.height() / 8.0);
  return {QPointF(0.5 * size.width(), size.height() - kBelow * scale - 18.0), scale};
}

QColor shaded(const modeling::Colour& colour, double light) {
  const double factor = 0.42 + 0.58 * std::clamp(light, 0.0, 1.0);
  return QColor::fromRgbF(static_cast<float>(colour[0] * factor), static_cast<float>(colour[1] * factor),
                          static_cast<float>(colour[2] * factor));
}

}  // namespace

SamplePreview::SamplePreview(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("sample-preview"));
  setFixedHeight(sizeHint().height());
  setToolTip(tr("A bar of 9 by 2 by 0.8 cm, thrown flat across a rod at 5 m/s, slowed down 48 times"));
  settling_.setSingleShot(true);
  settling_.setInterval(kSettling);
  frames_.setInterval(kFrameTime);
  connect(&settling_, &QTimer::timeout, this, &SamplePreview::start);
  connect(&frames_, &QTimer::timeout, this, &SamplePreview::tick);
}

void SamplePreview::setMaterial(const modeling::Material& material) {
  modeling::Material known = material_;
  known.name = material.name;
  known.source = material.source;
  known.look = material.look;
  const bool moves = known != material || !run_.isStarted();
  material_ = material;
  update();
  if (moves && isVisible()) settling_.start();
}

void SamplePreview::showEvent(QShowEvent*) {
  if (!run_.isStarted()) settling_.start();
  frames_.start();
}

void SamplePreview::hideEvent(QHideEvent*) {
  settling_.stop();
  frames_.stop();
  run_.stop();
}

void SamplePreview::start() {
  frame_ = 0;
  view_ = {};
  if (!modeling::validate(material_)) return update();
  run_.start(material_);
}

void SamplePreview::tick() {
  if (run_.isStarted() && !view_.done) view_ = run_.view();
  const int there = static_cast<int>(view_.frames.size());
  if (frame_ + 1 < there) {
    ++frame_;
  } else if (view_.done && there > 0) {
    frame_ = frame_ + 1 < there + kRestFrames ? frame_ + 1 : 0;
  }
  update();
}

QString SamplePreview::caption() const {
  if (view_.problem) return QString::fromStdString(view_.problem->what);
  if (!view_.done) return view_.frames.empty() ? tr("Preparing a sample") : tr("Trying a sample");
  return view_.broke ? tr("It breaks") : tr("It holds");
}

void SamplePreview::paintEvent(QPaintEvent*) {
  const Colours& colours = Theme::instance().colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QLinearGradient ground(0, 0, 0, height());
  ground.setColorAt(0.0, colours.viewTop);
  ground.setColorAt(1.0, colours.viewBottom);
  painter.setPen(colours.line);
  painter.setBrush(ground);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
  painter.setClipRect(rect().adjusted(1, 1, -1, -1));
  paintRod(painter);
  const int last = static_cast<int>(view_.frames.size()) - 1;
  if (last >= 0) paintMesh(painter, *view_.frames[static_cast<std::size_t>(std::min(frame_, last))]);
  painter.setPen(colours.dimText);
  painter.drawText(rect().adjusted(8, 0, -8, -5), Qt::AlignLeft | Qt::AlignBottom, caption());
}

void SamplePreview::paintRod(QPainter& painter) const {
  const Projection project = projectionOf(size());
  const Colours& colours = Theme::instance().colours();
  constexpr double kHalfLength = 1.8;
  const double radius = SampleRun::kRodRadius * project.scale;
  const QPointF front = project(sim::Vec3(0.0, -kHalfLength, 0.0));
  const QPointF back = project(sim::Vec3(0.0, kHalfLength, 0.0));
  painter.setPen(QPen(colours.grid, 2.0 * radius, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(back, front);
  painter.setPen(colours.gridStrong);
  painter.setBrush(colours.grid.lighter(125));
  painter.drawEllipse(front, radius, radius);
}

void SamplePreview::paintMesh(QPainter& painter, const sim::SurfaceMesh& mesh) const {
  const Projection project = projectionOf(size());
  const sim::Vec3 light = kLight.normalized();
  struct Drawn {
    double depth;
    QPolygonF outline;
    QColor colour;
  };
  std::vector<Drawn> faces;
  faces.reserve(mesh.faces.size());
  for (const sim::SurfaceMesh::Face& face : mesh.faces) {
    sim::Vec3 middle = sim::Vec3::Zero();
    sim::Vec3 normal = sim::Vec3::Zero();
    QPolygonF outline;
    double turned = 0.0;
    for (std::size_t i = 0; i < face.cornerCount; ++i) {
      const sim::Vec3& point = mesh.points[face.points[i]];
      middle += point / face.cornerCount;
      normal += mesh.normals[face.normals[i]] / face.cornerCount;
      outline << project(point);
      if (i > 0)
        turned += outline[static_cast<qsizetype>(i) - 1].x() * outline[static_cast<qsizetype>(i)].y() -
                  outline[static_cast<qsizetype>(i)].x() * outline[static_cast<qsizetype>(i) - 1].y();
    }
    turned += outline.back().x() * outline.front().y() - outline.front().x() * outline.back().y();
    // Counter-clockwise is below 0 where y runs downwards: the others are seen from behind.
    if (turned > 0.0) continue;
    const modeling::Colour& colour = face.inside ? material_.look.inside : material_.look.outside;
    faces.push_back({Projection::depth(middle), outline, shaded(colour, normal.dot(light))});
  }
  std::sort(faces.begin(), faces.end(), [](const Drawn& a, const Drawn& b) { return a.depth > b.depth; });
  for (const Drawn& face : faces) {
    // A line of its own colour closes the hairline between neighbours.
    painter.setPen(QPen(face.colour, 0.6));
    painter.setBrush(face.colour);
    painter.drawPolygon(face.outline);
  }
}

}  // namespace ui
