#include "ui/window/view_memory.h"

#include <QSettings>
#include <algorithm>

namespace ui {
namespace {

struct Named {
  const char* name;
  bool ViewSettings::*flag;
};

constexpr Named kFlags[] = {{"surface", &ViewSettings::surface},
                            {"nodes", &ViewSettings::nodes},
                            {"bonds", &ViewSettings::bonds},
                            {"brokenBonds", &ViewSettings::brokenBonds},
                            {"levelSurface", &ViewSettings::levelSurface},
                            {"gluePairs", &ViewSettings::gluePairs},
                            {"xray", &ViewSettings::xray},
                            {"insideColour", &ViewSettings::insideColour},
                            {"grid", &ViewSettings::grid},
                            {"shadows", &ViewSettings::shadows},
                            {"occlusion", &ViewSettings::occlusion},
                            {"invisibleColliders", &ViewSettings::invisibleColliders},
                            {"statistics", &ViewSettings::statistics}};

template <class Choice>
Choice choiceIn(const QSettings& settings, const char* name, Choice usual, Choice last) {
  const int value = settings.value(name, static_cast<int>(usual)).toInt();
  return static_cast<Choice>(std::clamp(value, 0, static_cast<int>(last)));
}

}  // namespace

ViewSettings recallView() {
  QSettings settings;
  settings.beginGroup("view");
  ViewSettings view;
  for (const Named& one : kFlags) view.*one.flag = settings.value(one.name, view.*one.flag).toBool();
  view.colouring = choiceIn(settings, "colouring", view.colouring, Colouring::quality);
  view.isolated = choiceIn(settings, "looseNodes", view.isolated, IsolatedNodes::hidden);
  return view;
}

void rememberView(const ViewSettings& view) {
  QSettings settings;
  settings.beginGroup("view");
  for (const Named& one : kFlags) settings.setValue(one.name, view.*one.flag);
  settings.setValue("colouring", static_cast<int>(view.colouring));
  settings.setValue("looseNodes", static_cast<int>(view.isolated));
}

}  // namespace ui
