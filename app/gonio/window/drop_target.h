// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <QStringList>
#include <functional>

class QDropEvent;
class QMimeData;
class QWidget;

namespace gonio::widgets {
class DropOverlay;
}

namespace gonio::app {

/// Accepts files dropped on a widget, and shows the effect of the drop during the drag.
class DropTarget : public QObject {
  Q_OBJECT

 public:
  /// Actions for each kind of file.
  struct Actions {
    std::function<void(const QString&path)> openMaterial, openReference, openEnvironment, openScene, openImage;
    std::function<void(const QString& folder)> openFolder = [](const QString&) {};
    std::function<void(const QStringList& paths)> openSeveral = [](const QStringList&) {};
  };

  /// Which drags are accepted: also materials that are dragged from the library, or only those of other programs.
  enum class Sources { all, otherPrograms };

  DropTarget(QWidget& window, Actions actions, Sources sources = Sources::all);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void drop(const QDropEvent& event);
  bool isAccepted(const QMimeData* data) const;

  Actions m_actions;
  Sources m_sources;
  widgets::DropOverlay* m_overlay;
};

}  // namespace gonio::app
