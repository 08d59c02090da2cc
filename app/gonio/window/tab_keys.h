// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

class QWidget;

namespace gonio::app {

/// Tab goes as the eye does: along a row, then to the row below; a panel is left when all of it was visited. Panels
/// make rows anew, fold and move, so the order is that of the places at the moment of the key. Holds for a window and
/// all windows that it opens.
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
