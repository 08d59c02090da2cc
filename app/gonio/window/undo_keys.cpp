// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/undo_keys.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>

namespace gonio::app {

namespace {

/// The field that a key goes to; null where it is none. Boxes hand their keys on to a field of their own.
const QLineEdit* fieldOf(const QObject* receiver) {
  if (const auto* field = qobject_cast<const QLineEdit*>(receiver)) return field;
  const bool holdsField = qobject_cast<const QAbstractSpinBox*>(receiver) || qobject_cast<const QComboBox*>(receiver);
  return holdsField ? receiver->findChild<const QLineEdit*>() : nullptr;
}

}  // namespace

UndoKeys::UndoKeys(QWidget* window) : QObject(window), m_window(window) { qApp->installEventFilter(this); }

bool UndoKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return false;
  const auto* key = static_cast<const QKeyEvent*>(event);
  const bool undo = key->matches(QKeySequence::Undo), redo = key->matches(QKeySequence::Redo);
  const bool endOfLine = key->modifiers() == Qt::ControlModifier && key->key() == Qt::Key_E;
  const QLineEdit* field = undo || redo || endOfLine ? fieldOf(watched) : nullptr;
  if (!field || field->window() != m_window) return false;
  if (endOfLine) {
    event->ignore();
    return true;
  }
  if (undo ? field->isUndoAvailable() : field->isRedoAvailable()) return false;
  event->ignore();
  return true;
}

}  // namespace gonio::app

#include "moc_undo_keys.cpp"
