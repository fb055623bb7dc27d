#include "ui/timeline/scene_difference.h"

#include <QCoreApplication>

namespace ui {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("Difference", text);
}

bool sameValues(const std::vector<modeling::SceneMaterial>& left,
                const std::vector<modeling::SceneMaterial>& right) {
  return std::equal(left.begin(), left.end(), right.begin(), right.end(),
                    [](const modeling::SceneMaterial& a, const modeling::SceneMaterial& b) {
                      return a.name == b.name && a.values == b.values;
                    });
}

}  // namespace

QStringList differencesOf(const modeling::Scene& left, const modeling::Scene& right) {
  QStringList found;
  if (left.parts != right.parts) found << tr("parts");
  if (left.glue != right.glue) found << tr("glue");
  if (!sameValues(left.materials, right.materials)) found << tr("materials");
  if (left.environment.gravity != right.environment.gravity) found << tr("gravity");
  if (left.environment.colliders != right.environment.colliders) found << tr("colliders");
  if (left.tracks != right.tracks) found << tr("tracks");
  if (left.solver != right.solver) found << tr("solver");
  if (left.output != right.output) found << tr("length or frames per second");
  return found;
}

}  // namespace ui
