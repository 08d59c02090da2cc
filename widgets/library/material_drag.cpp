// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/library/material_drag.h"

#include <QFileInfo>
#include <QMimeData>
#include <QUrl>

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

QString draggedMaterial(const QMimeData* data) {
  if (data->hasFormat(idFormat)) return QString::fromUtf8(data->data(idFormat));
  for (const QUrl& url : data->urls())
    if (url.isLocalFile()) return url.toLocalFile();
  return {};
}

}  // namespace gonio::widgets
