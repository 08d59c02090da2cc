// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/window_keys.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScrollBar>
#include <algorithm>
#include <vector>

namespace gonio::app {

namespace {

/// The field that a key goes to; null where it is none. Boxes hand their keys on to a field of their own.
const QLineEdit* fieldOf(const QObject* receiver) {
  if (const auto* field = qobject_cast<const QLineEdit*>(receiver)) return field;
  const bool holdsField = qobject_cast<const QAbstractSpinBox*>(receiver) || qobject_cast<const QComboBox*>(receiver);
  return holdsField ? receiver->findChild<const QLineEdit*>() : nullptr;
}

bool takesText(const QWidget* widget) {
  return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget);
}

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

WindowKeys::WindowKeys(QWidget* window, std::function<void(bool held)> flicker)
    : QObject(window), m_window(window), m_flicker(std::move(flicker)) {
  qApp->installEventFilter(this);
}

bool WindowKeys::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::WindowDeactivate:
      if (watched == m_window) setFlicker(false);
      return false;
    case QEvent::ShortcutOverride:
      return passOn(watched, static_cast<QKeyEvent&>(*event));
    case QEvent::Wheel:
      return ignoresWheel(watched, *event);
    case QEvent::KeyPress:
      orderTabs(watched, static_cast<const QKeyEvent&>(*event));
      [[fallthrough]];
    case QEvent::KeyRelease: {
      const auto* widget = qobject_cast<const QWidget*>(watched);
      return widget && widget->window() == m_window && flicker(widget, static_cast<const QKeyEvent&>(*event));
    }
    default:
      return false;
  }
}

/// The wheel scrolls. It changes a value only in a field for numbers or a slider that has the focus, and never the
/// choice of a list box. @return whether the receiver does not get the wheel, which goes to its parent then.
bool WindowKeys::ignoresWheel(const QObject* watched, QEvent& event) const {
  const auto* widget = qobject_cast<const QWidget*>(watched);
  if (!widget || qobject_cast<const QScrollBar*>(widget)) return false;
  const bool isList = qobject_cast<const QComboBox*>(widget);
  const bool isNumber = qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QAbstractSlider*>(widget);
  if (!isList && !(isNumber && !widget->hasFocus())) return false;
  event.ignore();
  return true;
}

/// Undo, redo and Ctrl+E in a text field. @return whether the field does not get the key.
bool WindowKeys::passOn(const QObject* watched, QKeyEvent& key) const {
  const bool undo = key.matches(QKeySequence::Undo), redo = key.matches(QKeySequence::Redo);
  const bool endOfLine = key.modifiers() == Qt::ControlModifier && key.key() == Qt::Key_E;
  const QLineEdit* field = undo || redo || endOfLine ? fieldOf(watched) : nullptr;
  if (!field || field->window() != m_window) return false;
  if ((undo && field->isUndoAvailable()) || (redo && field->isRedoAvailable())) return false;
  key.ignore();
  return true;
}

void WindowKeys::orderTabs(const QObject* watched, const QKeyEvent& key) const {
  if (watched != QApplication::focusWidget()) return;
  if (key.key() != Qt::Key_Tab && key.key() != Qt::Key_Backtab) return;
  QWidget* window = static_cast<const QWidget*>(watched)->window();
  for (const QWidget* owner = window; owner; owner = owner->parentWidget())
    if (owner == m_window) return orderByPlace(*window);
}

/// The key for flicker. @return whether nothing else gets it.
bool WindowKeys::flicker(const QWidget* widget, const QKeyEvent& key) {
  if (key.key() != Qt::Key_Backslash) return false;
  if (key.type() == QEvent::KeyRelease) {
    if (!key.isAutoRepeat()) setFlicker(false);
    return m_held;
  }
  if (takesText(widget) || key.modifiers() & Qt::ControlModifier) return false;
  setFlicker(true);
  return true;
}

void WindowKeys::setFlicker(bool held) {
  if (held == m_held) return;
  m_held = held;
  m_flicker(held);
}

}  // namespace gonio::app

#include "moc_window_keys.cpp"
