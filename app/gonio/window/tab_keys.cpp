// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/tab_keys.h"

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>
#include <algorithm>
#include <vector>

namespace gonio::app {

namespace {

using Widgets = std::vector<QWidget*>;

Widgets visibleChildren(const QWidget& parent) {
  Widgets children;
  for (QObject* object : parent.children())
    if (auto* child = qobject_cast<QWidget*>(object); child && child->isVisible() && !child->isWindow())
      children.push_back(child);
  return children;
}

bool isInRow(const QRect& place, const QRect& first) {
  const int common = std::min(place.bottom(), first.bottom()) - std::max(place.top(), first.top());
  return 2 * common > std::min(place.height(), first.height());
}

/// Siblings in rows from top to bottom, each from left to right. What is beside the first of a row is in it.
void sortByPlace(Widgets& siblings) {
  std::ranges::stable_sort(siblings, {}, [](const QWidget* one) { return one->geometry().top(); });
  for (auto first = siblings.begin(); first != siblings.end();) {
    const QRect place = (*first)->geometry();
    const auto next = std::stable_partition(first, siblings.end(),
                                            [&](const QWidget* one) { return isInRow(one->geometry(), place); });
    std::stable_sort(first, next, [](const QWidget* a, const QWidget* b) { return a->x() < b->x(); });
    first = std::max(next, first + 1);
  }
}

void addStops(QWidget& widget, Widgets& stops) {
  if (widget.focusPolicy() & Qt::TabFocus && !widget.focusProxy()) stops.push_back(&widget);
  Widgets children = visibleChildren(widget);
  sortByPlace(children);
  for (QWidget* child : children) addStops(*child, stops);
}

void orderByPlace(QWidget& window) {
  Widgets stops;
  addStops(window, stops);
  for (std::size_t i = 1; i < stops.size(); ++i) QWidget::setTabOrder(stops[i - 1], stops[i]);
}

}  // namespace

TabKeys::TabKeys(QWidget* window) : QObject(window), m_window(window) { qApp->installEventFilter(this); }

bool TabKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress || watched != QApplication::focusWidget()) return false;
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key != Qt::Key_Tab && key != Qt::Key_Backtab) return false;
  QWidget* window = static_cast<QWidget*>(watched)->window();
  for (const QWidget* owner = window; owner; owner = owner->parentWidget())
    if (owner == m_window) {
      orderByPlace(*window);
      break;
    }
  return false;
}

}  // namespace gonio::app

#include "moc_tab_keys.cpp"
