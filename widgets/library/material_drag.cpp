// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/library/material_drag.h"

#include <QFileInfo>
#include <QMimeData>
#include <QUrl>

#include "core/documents/edit_document.h"
#include "core/materials/material_formats.h"

namespace gonio::widgets {

namespace {
const QString idFormat = QStringLiteral("application/x-gonio-material");
}

QMimeData* toDrag(const QString& id) {
  auto* data = new QMimeData;
  data->setData(idFormat, id.toUtf8());
  if (QFileInfo(id).isAbsolute()) data->setUrls({QUrl::fromLocalFile(id)});
  return data;
}

QString draggedFile(const QMimeData* data) {
  if (data->hasFormat(idFormat)) return QString::fromUtf8(data->data(idFormat));
  for (const QUrl& url : data->urls())
    if (url.isLocalFile()) return url.toLocalFile();
  return {};
}

QStringList draggedFiles(const QMimeData* data) {
  QStringList files;
  if (data->hasFormat(idFormat)) return files;
  for (const QUrl& url : data->urls())
    if (url.isLocalFile()) files << url.toLocalFile();
  return files;
}

QString draggedMaterial(const QMimeData* data) {
  const QString file = draggedFile(data);
  const std::string path = file.toStdString();
  const bool isMaterial =
      data->hasFormat(idFormat) || documents::isDocumentName(path) || materials::isMaterialFile(path);
  return isMaterial ? file : QString();
}

}  // namespace gonio::widgets
