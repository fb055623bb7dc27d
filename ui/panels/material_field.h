#pragma once

#include <QWidget>

#include "modeling/scene/scene.h"

class QToolButton;

namespace ui {

class ChoiceField;

/// Which material, with its colour, a button to see its properties and one for a new material.
class MaterialField : public QWidget {
  Q_OBJECT

 public:
  explicit MaterialField(QWidget* parent = nullptr);
  /// `chosen` "": none, or several that differ.
  void show(const modeling::Scene& scene, const QString& chosen);

 signals:
  void chosen(const QString& name);
  /// A new one made of a preset.
  void newWanted(const QString& preset);
  void openWanted();

 private:
  void openPresets();

  ChoiceField* choice_;
  QToolButton* open_;
  QToolButton* add_;
};

/// Adds a material made of a preset under a name of its own; answers the name.
std::string addMaterial(modeling::Scene& scene, const std::string& preset);

}  // namespace ui
