// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

class QWidget;

namespace gonio::app {

/// Text fields keep the keys of undo and redo for themselves, also when there is no typing that they could take back.
/// Within a window this object passes them on then, so that they undo and redo steps of the document; and always
/// Ctrl+E, which fields take for the end of the line (End does that too) and the window for an export.
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
