// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/drop_target.h"

#include <QDragEnterEvent>
#include <QMimeData>

#include "app/gonio/window/dropped_files.h"
#include "widgets/library/material_drag.h"
#include "widgets/panels/drop_overlay.h"

namespace gonio::app {

DropTarget::DropTarget(QWidget& window, Actions actions)
    : QObject(&window), m_actions(std::move(actions)), m_overlay(new widgets::DropOverlay(&window)) {
  window.setAcceptDrops(true);
  window.installEventFilter(this);
}

bool DropTarget::eventFilter(QObject*, QEvent* event) {
  switch (event->type()) {
    case QEvent::DragEnter: {
      auto& enter = static_cast<QDragEnterEvent&>(*event);
      const QString file = widgets::draggedFile(enter.mimeData());
      if (file.isEmpty()) return true;
      m_overlay->announce(dropDescription(file, enter.modifiers() & Qt::ControlModifier));
      enter.acceptProposedAction();
      return true;
    }
    case QEvent::DragLeave:
      m_overlay->hide();
      return true;
    case QEvent::Drop:
      m_overlay->hide();
      drop(static_cast<QDropEvent&>(*event));
      static_cast<QDropEvent&>(*event).acceptProposedAction();
      return true;
    default:
      return false;
  }
}

void DropTarget::drop(const QDropEvent& event) {
  const QString file = widgets::draggedFile(event.mimeData());
  if (isEnvironmentFile(file))
    m_actions.openEnvironment(file);
  else if (isScene(file))
    m_actions.openScene(file);
  else if (!file.isEmpty() && event.modifiers() & Qt::ControlModifier)
    m_actions.openReference(file);
  else if (!file.isEmpty())
    m_actions.openMaterial(file);
}

}  // namespace gonio::app

#include "moc_drop_target.cpp"
