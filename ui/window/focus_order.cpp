#include "ui/window/focus_order.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QScrollArea>
#include <QTabBar>
#include <QToolBar>
#include <algorithm>
#include <optional>
#include <utility>

namespace ui {
namespace {

/// What only holds others together, and what is only looked at, is passed over.
bool takesFocus(const QWidget& widget) {
  if (qobject_cast<const QScrollArea*>(&widget) != nullptr) return false;
  return (widget.focusPolicy() & Qt::TabFocus) != 0 && widget.isEnabled() && widget.isVisible() &&
         widget.focusProxy() == nullptr;
}

QRect placeIn(const QWidget& panel, const QWidget& widget) {
  return {widget.mapTo(&panel, QPoint()), widget.size()};
}

/// A dock that stands behind another one is visible, but nothing of it is seen.
bool isSeen(const QWidget& widget) {
  return widget.isVisible() && !widget.visibleRegion().isEmpty();
}

int rankOf(const QMainWindow& window, const QWidget& place) {
  if (qobject_cast<const QToolBar*>(&place) != nullptr) return 0;
  const QRect middle = placeIn(window, *window.centralWidget());
  const QRect here = placeIn(window, place);
  if (here.top() >= middle.bottom()) return 4;
  if (here.right() <= middle.left()) return 1;
  return here.left() >= middle.right() ? 3 : 2;
}

/// Where in the list the focus is: at the innermost that holds it. What is inside of something comes after
/// it.
std::optional<std::size_t> holderOfFocus(const std::vector<QWidget*>& list) {
  const QWidget* focus = QApplication::focusWidget();
  std::optional<std::size_t> found;
  for (std::size_t i = 0; focus != nullptr && i < list.size(); ++i)
    if (list[i] == focus || list[i]->isAncestorOf(focus)) found = i;
  return found;
}

/// Round and round.
QWidget* neighbour(const std::vector<QWidget*>& list, bool forwards) {
  const std::optional<std::size_t> holder = holderOfFocus(list);
  if (!holder) return forwards ? list.front() : list.back();
  return list[(*holder + (forwards ? 1 : list.size() - 1)) % list.size()];
}

/// Puts a line after the other in order, each with what is inside of its members.
void sortIntoLines(const QWidget& panel, std::vector<QWidget*> rest, std::vector<QWidget*>& order) {
  std::stable_sort(rest.begin(), rest.end(), [&](const QWidget* a, const QWidget* b) {
    return placeIn(panel, *a).center().y() < placeIn(panel, *b).center().y();
  });
  while (!rest.empty()) {
    // All whose middles are not below the first one's end.
    const int end = placeIn(panel, *rest.front()).bottom();
    const auto line = std::stable_partition(rest.begin(), rest.end(), [&](const QWidget* widget) {
      return placeIn(panel, *widget).center().y() <= end;
    });
    std::stable_sort(rest.begin(), line, [&](const QWidget* a, const QWidget* b) {
      return placeIn(panel, *a).left() < placeIn(panel, *b).left();
    });
    for (auto widget = rest.begin(); widget != line; ++widget) {
      order.push_back(*widget);
      const std::vector<QWidget*> inside = readingOrder(**widget);
      order.insert(order.end(), inside.begin(), inside.end());
    }
    rest.erase(rest.begin(), line);
  }
}

}  // namespace

std::vector<QWidget*> readingOrder(const QWidget& panel) {
  std::vector<QWidget*> outermost;
  const std::vector<QWidget*> all = [&] {
    std::vector<QWidget*> found;
    for (QWidget* widget : panel.findChildren<QWidget*>())
      if (takesFocus(*widget) && widget->window() == panel.window()) found.push_back(widget);
    return found;
  }();
  for (QWidget* widget : all) {
    const bool inside = std::any_of(all.begin(), all.end(), [&](const QWidget* other) {
      return other != widget && other->isAncestorOf(widget);
    });
    if (!inside) outermost.push_back(widget);
  }
  std::vector<QWidget*> order;
  sortIntoLines(panel, std::move(outermost), order);
  return order;
}

std::vector<QWidget*> placesOf(const QMainWindow& window) {
  std::vector<std::pair<int, QWidget*>> places;
  const auto add = [&](QWidget* place) {
    if (isSeen(*place) && (takesFocus(*place) || !readingOrder(*place).empty()))
      places.emplace_back(rankOf(window, *place), place);
  };
  for (auto* bar : window.findChildren<QToolBar*>(Qt::FindDirectChildrenOnly)) add(bar);
  for (auto* tabs : window.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly)) add(tabs);
  for (auto* dock : window.findChildren<QDockWidget*>()) add(dock);
  add(window.centralWidget());
  std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) {
    if (a.first != b.first) return a.first < b.first;
    return a.second->y() < b.second->y();
  });
  std::vector<QWidget*> found;
  for (const auto& [rank, place] : places) found.push_back(place);
  return found;
}

bool moveFocus(const QMainWindow& window, bool forwards) {
  std::vector<QWidget*> order;
  for (QWidget* place : placesOf(window)) {
    if (takesFocus(*place)) order.push_back(place);
    const std::vector<QWidget*> inside = readingOrder(*place);
    order.insert(order.end(), inside.begin(), inside.end());
  }
  if (order.empty()) return false;
  neighbour(order, forwards)->setFocus(forwards ? Qt::TabFocusReason : Qt::BacktabFocusReason);
  return true;
}

void moveFocusToPlace(const QMainWindow& window, bool forwards) {
  const std::vector<QWidget*> places = placesOf(window);
  if (places.empty()) return;
  QWidget* place = neighbour(places, forwards);
  const std::vector<QWidget*> inside = readingOrder(*place);
  (takesFocus(*place) || inside.empty() ? place : inside.front())->setFocus(Qt::TabFocusReason);
}

}  // namespace ui
