// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <functional>

class QDropEvent;
class QWidget;

namespace gonio::widgets {
class DropOverlay;
}

namespace gonio::app {

/// Accepts files dropped on a window, and shows the effect of the drop during the drag.
class DropTarget : public QObject {
  Q_OBJECT

 public:
  /// Actions for each kind of file.
  struct Actions {
    std::function<void(const QString&path)> openMaterial, openReference, openEnvironment, openScene, openImage;
  };

  DropTarget(QWidget& window, Actions actions);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void drop(const QDropEvent& event);

  Actions m_actions;
  widgets::DropOverlay* m_overlay;
};

}  // namespace gonio::app
