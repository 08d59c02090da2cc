// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

class QWidget;

namespace gonio::app {

/// Tab follows the reading order: along a row, then to the row below, and to the next panel after the whole panel.
/// Because panels recreate rows, collapse and move, the order is computed from the positions at each key press. Applies
/// to a window and all windows that it opens.
class TabKeys : public QObject {
  Q_OBJECT

 public:
  explicit TabKeys(QWidget* window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* m_window;
};

}  // namespace gonio::app
