#include "ui/editors/glue_editing.h"

#include <algorithm>
#include <cmath>

namespace ui {
namespace {

constexpr int kPollMilliseconds = 15;
const QString kReachGesture = QStringLiteral("glue reach");

double cellSizeOf(const modeling::Part& part) {
  return modeling::cellEdgeOf(part.shape).value_or(modeling::Resolution{}.cellSize);
}

const modeling::Part* partOf(const modeling::Scene& scene, const std::string& name) {
  for (const modeling::Part& part : scene.parts)
    if (part.name == name) return &part;
  return nullptr;
}

std::optional<std::size_t> gluingOf(const modeling::Scene& scene, const std::string& a,
                                    const std::string& b) {
  for (std::size_t i = 0; i < scene.glue.size(); ++i) {
    const modeling::Gluing& gluing = scene.glue[i];
    if ((gluing.a == a && gluing.b == b) || (gluing.a == b && gluing.b == a)) return i;
  }
  return std::nullopt;
}

/// The one gluing in which the part takes part.
std::optional<std::size_t> onlyGluingOf(const modeling::Scene& scene, const std::string& part) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < scene.glue.size(); ++i) {
    if (scene.glue[i].a != part && scene.glue[i].b != part) continue;
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

}  // namespace

GlueEditing::GlueEditing(Session& session, QObject* parent)
    : QObject(parent),
      session_(session),
      worker_(
          [previewer = std::make_shared<GluePreviewer>()](const Request& request, auto& job) -> sim::Status {
            job.value = previewer->outcome(request.scene, request.gluing, request.folder);
            return sim::Done{};
          }) {
  timer_.setInterval(kPollMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &GlueEditing::poll);
  connect(&session_.document(), &Document::sceneChanged, this, &GlueEditing::follow);
  connect(&session_.document(), &Document::replaced, this, &GlueEditing::end);
}

void GlueEditing::begin() {
  end();
  const modeling::Scene& scene = session_.document().scene();
  const std::vector<Item>& items = session_.selection().items();
  if (!items.empty() && items.back().kind == ItemKind::gluing) return edit(items.back().index);
  std::vector<std::string> parts;
  for (const Item& item : items)
    if (item.kind == ItemKind::part) parts.push_back(scene.parts[item.index].name);
  if (parts.size() == 1) {
    if (const std::optional<std::size_t> gluing = onlyGluingOf(scene, parts.front())) return edit(*gluing);
  }
  stage_ = Stage::chooseA;
  if (parts.size() == 2)
    for (const std::string& part : parts) choose(part);
  emit changed();
}

void GlueEditing::edit(std::size_t gluing) {
  const modeling::Scene& scene = session_.document().scene();
  if (gluing >= scene.glue.size()) return;
  existing_ = gluing;
  glueCount_ = scene.glue.size();
  gluing_ = scene.glue[gluing];
  stage_ = Stage::adjust;
  outcome_.reset();
  request();
  emit changed();
}

void GlueEditing::choose(const std::string& part) {
  if (stage_ == Stage::chooseA) {
    gluing_ = {};
    gluing_.a = part;
    stage_ = Stage::chooseB;
  } else if (stage_ == Stage::chooseB && part != gluing_.a) {
    if (const auto same = gluingOf(session_.document().scene(), gluing_.a, part)) {
      session_.selection().select({ItemKind::gluing, *same});
      return edit(*same);
    }
    gluing_.b = part;
    gluing_.reach = usualReach();
    stage_ = Stage::adjust;
    request();
  }
  emit changed();
}

void GlueEditing::end() {
  if (stage_ == Stage::off) return;
  stage_ = Stage::off;
  existing_.reset();
  gluing_ = {};
  outcome_.reset();
  timer_.stop();
  session_.document().endGesture();
  emit changed();
}

/// About half a cell is usual (modeling/glue/glue.h).
double GlueEditing::usualReach() const {
  const modeling::Scene& scene = session_.document().scene();
  double size = 0.0;
  for (const std::string& name : {gluing_.a, gluing_.b})
    if (const modeling::Part* part = partOf(scene, name)) size = std::max(size, cellSizeOf(*part));
  return std::max(0.05, std::round(size * 50.0) / 100.0);
}

void GlueEditing::change(const QString& name, const std::function<void(modeling::Gluing&)>& change,
                         const QString& gesture) {
  if (stage_ != Stage::adjust) return;
  if (existing_) {
    // follow() takes it over from the scene.
    session_.document().edit(
        name, [&](modeling::Scene& scene) { change(scene.glue[*existing_]); }, gesture);
    return;
  }
  // What is not in the scene yet is not typed into it either.
  if (session_.document().isRehearsing()) return;
  change(gluing_);
  request();
  emit changed();
}

void GlueEditing::setReach(double reach, bool finished) {
  change(
      tr("Reach of glue"), [&](modeling::Gluing& gluing) { gluing.reach = reach; }, kReachGesture);
  if (finished) session_.document().endGesture();
}

void GlueEditing::reachNearest() {
  if (!outcome_ || !outcome_->nearest) return;
  // A little more than the nearest pair, so that its neighbours come along.
  setReach(std::ceil(outcome_->nearest->distance() * 125.0) / 100.0, true);
}

void GlueEditing::toggle(modeling::NodeIndex node) {
  const bool isOut = std::find(gluing_.exclude.begin(), gluing_.exclude.end(), node) != gluing_.exclude.end();
  change(isOut ? tr("Put node back into glue") : tr("Take node out of glue"), [&](modeling::Gluing& gluing) {
    if (!gluing.pairs.empty()) {
      std::erase_if(gluing.pairs, [&](const auto& pair) { return pair[0] == node; });
    } else if (isOut) {
      std::erase(gluing.exclude, node);
    } else {
      gluing.exclude.insert(std::lower_bound(gluing.exclude.begin(), gluing.exclude.end(), node), node);
    }
  });
}

void GlueEditing::setRegion(const std::optional<modeling::Box>& region) {
  change(region ? tr("Glue in a box") : tr("Glue everywhere"),
         [&](modeling::Gluing& gluing) { gluing.region = region; });
}

void GlueEditing::swap() {
  change(tr("Swap glued parts"), [](modeling::Gluing& gluing) {
    std::swap(gluing.a, gluing.b);
    for (auto& pair : gluing.pairs) std::swap(pair[0], pair[1]);
    // Nodes of the other part, and a box in its coordinates.
    gluing.exclude.clear();
    gluing.region.reset();
  });
}

void GlueEditing::glue() {
  if (stage_ != Stage::adjust || existing_) return;
  const modeling::Gluing made = gluing_;
  const std::size_t index = session_.document().scene().glue.size();
  existing_ = index;
  glueCount_ = index + 1;
  session_.document().edit(
      tr("Glue %1 to %2").arg(QString::fromStdString(made.a), QString::fromStdString(made.b)),
      [&](modeling::Scene& scene) { scene.glue.push_back(made); });
  session_.selection().select({ItemKind::gluing, index});
}

void GlueEditing::remove() {
  if (!existing_) return;
  const std::size_t index = *existing_;
  end();
  session_.document().edit(tr("Delete glue"), [&](modeling::Scene& scene) {
    scene.glue.erase(scene.glue.begin() + static_cast<std::ptrdiff_t>(index));
  });
}

/// The scene was edited or undone: parts may have gone or changed, and so may the gluing.
void GlueEditing::follow() {
  if (stage_ == Stage::off) return;
  const modeling::Scene& scene = session_.document().scene();
  if (existing_) {
    const auto sameParts = gluingOf(scene, gluing_.a, gluing_.b);
    // Without it either a part was renamed, and the gluing stands where it stood, or it is gone.
    if (!sameParts && scene.glue.size() != glueCount_) return end();
    if (sameParts) existing_ = sameParts;
    if (*existing_ >= scene.glue.size()) return end();
    glueCount_ = scene.glue.size();
    gluing_ = scene.glue[*existing_];
  } else {
    const bool hasA = stage_ == Stage::chooseA || partOf(scene, gluing_.a) != nullptr;
    const bool hasB = stage_ != Stage::adjust || partOf(scene, gluing_.b) != nullptr;
    if (!hasA || !hasB) {
      gluing_ = {};
      outcome_.reset();
      stage_ = Stage::chooseA;
    }
  }
  if (stage_ == Stage::adjust) request();
  emit changed();
}

void GlueEditing::request() {
  Request request;
  request.scene = session_.document().scene();
  request.folder = session_.document().folder();
  request.gluing = existing_.value_or(request.scene.glue.size());
  if (!existing_) request.scene.glue.push_back(gluing_);
  worker_.request(std::move(request));
  timer_.start();
}

void GlueEditing::poll() {
  const bool busy = worker_.isBusy();
  const auto answer = worker_.newest();
  const std::shared_ptr<const GlueOutcome> newest(answer, &answer->value);
  if (!busy) timer_.stop();
  if (newest != outcome_ && answer->ended && stage_ == Stage::adjust && newest->gluing.a == gluing_.a &&
      newest->gluing.b == gluing_.b)
    outcome_ = newest;
  emit changed();
}

}  // namespace ui
