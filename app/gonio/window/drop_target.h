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

/// Takes files that are dropped on a window, and says meanwhile what dropping them will do.
class DropTarget : public QObject {
  Q_OBJECT

 public:
  /// What to do with a file of each kind.
  struct Actions {
    std::function<void(const QString&path)> openMaterial, openReference, openEnvironment, openScene;
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
