// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

class QWidget;

namespace gonio::app {

/// Text fields consume the undo and redo keys even if they have nothing to undo. In that case this object passes the
/// keys on within a window, so that they undo and redo steps of the document. It always passes on Ctrl+E: text fields
/// use it to move to the end of the line (like End), but in the window it exports the BRDF.
class UndoKeys : public QObject {
  Q_OBJECT

 public:
  explicit UndoKeys(QWidget* window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* m_window;
};

}  // namespace gonio::app
