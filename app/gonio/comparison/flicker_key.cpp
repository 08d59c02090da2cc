// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/comparison/flicker_key.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>

namespace gonio::app {

namespace {
bool takesText(const QWidget* widget) {
  return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget);
}
}  // namespace

FlickerKey::FlickerKey(QWidget* window, std::function<void(bool held)> callback)
    : QObject(window), m_window(window), m_callback(std::move(callback)) {
  qApp->installEventFilter(this);
}

void FlickerKey::set(bool held) {
  if (held == m_held) return;
  m_held = held;
  m_callback(held);
}

bool FlickerKey::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::WindowDeactivate && watched == m_window) set(false);
  if (event->type() != QEvent::KeyPress && event->type() != QEvent::KeyRelease) return false;
  const auto* widget = qobject_cast<const QWidget*>(watched);
  const auto* key = static_cast<const QKeyEvent*>(event);
  if (!widget || widget->window() != m_window || key->key() != Qt::Key_Backslash) return false;
  if (event->type() == QEvent::KeyRelease) {
    if (!key->isAutoRepeat()) set(false);
    return m_held;
  }
  if (takesText(widget) || key->modifiers() & Qt::ControlModifier) return false;
  set(true);
  return true;
}

}  // namespace gonio::app

#include "moc_flicker_key.cpp"
