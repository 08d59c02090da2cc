// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/dropped_files.h"

#include <QCoreApplication>

#include "core/io/mesh_file.h"

namespace gonio::app {

bool isEnvironmentFile(const QString& path) {
  return path.endsWith(QStringLiteral(".hdr"), Qt::CaseInsensitive) ||
         path.endsWith(QStringLiteral(".exr"), Qt::CaseInsensitive);
}

bool isScene(const QString& path) {
  return io::isMeshFile(path.toStdString()) || path.endsWith(QStringLiteral(".json"), Qt::CaseInsensitive);
}

QString dropDescription(const QString& path, bool asReference) {
  const QString text =
      isEnvironmentFile(path) ? QCoreApplication::translate("DroppedFiles", "Light the preview with %1")
      : isScene(path)         ? QCoreApplication::translate("DroppedFiles", "Show the material in the scene %1")
      : asReference           ? QCoreApplication::translate("DroppedFiles", "Compare with %1")
                              : QCoreApplication::translate("DroppedFiles", "Open %1 (with Ctrl: compare)");
  return text.arg(path.section('/', -1));
}

}  // namespace gonio::app
