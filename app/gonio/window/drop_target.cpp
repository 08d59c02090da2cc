// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/drop_target.h"

#include <QCoreApplication>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QString>

#include "app/gonio/matching/reference_image.h"
#include "core/io/mesh_file.h"
#include "widgets/library/material_drag.h"
#include "widgets/panels/drop_overlay.h"

namespace gonio::app {

namespace {

/// Whether a file is an environment image, by its suffix.
bool isEnvironmentFile(const QString& path) {
  return path.endsWith(QStringLiteral(".hdr"), Qt::CaseInsensitive) ||
         path.endsWith(QStringLiteral(".exr"), Qt::CaseInsensitive);
}

/// Whether a file is a scene or a mesh, by its suffix.
bool isScene(const QString& path) {
  return io::isMeshFile(path.toStdString()) || path.endsWith(QStringLiteral(".json"), Qt::CaseInsensitive);
}

/// Describes the effect of dropping a file. @param asReference whether a material becomes the reference of comparisons.
QString dropDescription(const QString& path, bool asReference = false) {
  const QString text =
      QFileInfo(path).isDir()      ? QCoreApplication::translate("DroppedFiles", "Show the folder %1 in the library")
      : isEnvironmentFile(path)    ? QCoreApplication::translate("DroppedFiles", "Light the preview with %1")
      : isReferenceImageFile(path) ? QCoreApplication::translate("DroppedFiles", "Show the reference image %1")
      : isScene(path)              ? QCoreApplication::translate("DroppedFiles", "Show the material in the scene %1")
      : asReference                ? QCoreApplication::translate("DroppedFiles", "Compare with %1")
                                   : QCoreApplication::translate("DroppedFiles", "Open %1 (with Ctrl: compare)");
  return text.arg(path.section('/', -1));
}

/// Materials and documents among several files, which open as a selection of the library.
QStringList materialsOf(const QStringList& files) {
  QStringList materials;
  for (const QString& file : files)
    if (!isEnvironmentFile(file) && !isReferenceImageFile(file) && !isScene(file) && !QFileInfo(file).isDir())
      materials << file;
  return materials;
}

}  // namespace

DropTarget::DropTarget(QWidget& window, Actions actions, Sources sources)
    : QObject(&window),
      m_actions(std::move(actions)),
      m_sources(sources),
      m_overlay(new widgets::DropOverlay(&window)) {
  window.setAcceptDrops(true);
  window.installEventFilter(this);
}

bool DropTarget::isAccepted(const QMimeData* data) const {
  return !(m_sources == Sources::all ? QStringList{widgets::draggedFile(data)} : widgets::draggedFiles(data))
              .join(QString())
              .isEmpty();
}

bool DropTarget::eventFilter(QObject*, QEvent* event) {
  switch (event->type()) {
    case QEvent::DragEnter: {
      auto& enter = static_cast<QDragEnterEvent&>(*event);
      if (!isAccepted(enter.mimeData())) {
        enter.ignore();
        return true;
      }
      const QString file = widgets::draggedFile(enter.mimeData());
      const qsizetype count = materialsOf(widgets::draggedFiles(enter.mimeData())).size();
      m_overlay->announce(
          count > 1 ? QCoreApplication::translate("DroppedFiles", "Show %1 materials in the library").arg(count)
                    : dropDescription(file, enter.modifiers() & Qt::ControlModifier));
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
  if (const QStringList materials = materialsOf(widgets::draggedFiles(event.mimeData())); materials.size() > 1)
    m_actions.openSeveral(materials);
  else if (QFileInfo(file).isDir())
    m_actions.openFolder(file);
  else if (isEnvironmentFile(file))
    m_actions.openEnvironment(file);
  else if (isReferenceImageFile(file))
    m_actions.openImage(file);
  else if (isScene(file))
    m_actions.openScene(file);
  else if (!file.isEmpty() && event.modifiers() & Qt::ControlModifier)
    m_actions.openReference(file);
  else if (!file.isEmpty())
    m_actions.openMaterial(file);
}

}  // namespace gonio::app

#include "moc_drop_target.cpp"
