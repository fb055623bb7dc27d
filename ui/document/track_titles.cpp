#include "ui/document/track_titles.h"

#include <QCoreApplication>

namespace ui {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("TrackTitles", text);
}

}  // namespace

QString titleOf(const modeling::TargetName& target) {
  const QString object = QString::fromStdString(target.object);
  switch (target.target) {
    case sim::TrackTarget::gravityScale:
      return tr("Gravity scale");
    case sim::TrackTarget::gravity:
      return tr("Gravity");
    case sim::TrackTarget::stiffnessScale:
      return object.isEmpty() ? tr("Stiffness") : tr("Stiffness of %1").arg(object);
    case sim::TrackTarget::dampingScale:
      return object.isEmpty() ? tr("Damping") : tr("Damping of %1").arg(object);
    case sim::TrackTarget::colliderPosition:
      return tr("Position of %1").arg(object);
    case sim::TrackTarget::colliderRotation:
      return tr("Rotation of %1").arg(object);
  }
  return {};
}

QString unitText(modeling::TrackUnit unit) {
  switch (unit) {
    case modeling::TrackUnit::acceleration:
      return tr("cm/s\u00b2");
    case modeling::TrackUnit::length:
      return tr("cm");
    case modeling::TrackUnit::degrees:
      return tr("\u00b0");
    case modeling::TrackUnit::factor:
      break;
  }
  return QStringLiteral("\u00d7");
}

}  // namespace ui
