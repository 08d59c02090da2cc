// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <functional>

class QKeyEvent;
class QWidget;

namespace gonio::app {

/// Keys of a window that shortcuts cannot express, and its wheel.
///
/// - Undo and redo: text fields consume these keys even if they have nothing to undo. In that case they are passed on
///   and undo and redo steps of the document. Ctrl+E is always passed on: text fields use it to move to the end
///   of the line (like End), but in the window it exports the BRDF.
/// - Tab follows the reading order: along a row, then to the row below, and to the next panel after the whole panel.
///   Because panels recreate rows, collapse and move, the order is computed from the positions at each key press. This
///   applies to the window and all windows that it opens.
/// - The wheel scrolls: it changes a value only in a field or slider that has the focus, and never a list box.
/// - The key \ with any focus except a text field: reported when it is pressed and when it is released.
class WindowKeys : public QObject {
  Q_OBJECT

 public:
  /// @param flicker called when the key \ is pressed or released.
  WindowKeys(QWidget* window, std::function<void(bool held)> flicker);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool ignoresWheel(const QObject* watched, QEvent& event) const;
  bool passOn(const QObject* watched, QKeyEvent& key) const;
  void orderTabs(const QObject* watched, const QKeyEvent& key) const;
  bool flicker(const QWidget* widget, const QKeyEvent& key);
  void setFlicker(bool held);

  QWidget* m_window;
  std::function<void(bool)> m_flicker;
  bool m_held = false;  ///< whether the key \ is held
};

}  // namespace gonio::app
