// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/inputs/scaled_pixmap.h"

#include <QPixmapCache>

namespace gonio::widgets {

QPixmap scaledPixmap(const QPixmap& pixmap, const QSize& size) {
  const QString key = QStringLiteral("scaled/%1/%2x%3").arg(pixmap.cacheKey()).arg(size.width()).arg(size.height());
  QPixmap result;
  if (!QPixmapCache::find(key, &result)) {
    result = pixmap.scaled(size, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QPixmapCache::insert(key, result);
  }
  return result;
}

}  // namespace gonio::widgets
