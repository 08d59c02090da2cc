// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/interpolation/sphere_picture.h"

#include <QPainter>
#include <QPalette>
#include <QPixmapCache>

namespace gonio::widgets {

QPixmap sphereAtSize(const QImage& picture, const QSize& pixels) {
  const QString key =
      QStringLiteral("sphere-%1-%2x%3").arg(picture.cacheKey()).arg(pixels.width()).arg(pixels.height());
  QPixmap scaled;
  if (QPixmapCache::find(key, &scaled)) return scaled;
  scaled = QPixmap::fromImage(picture.scaled(pixels, Qt::KeepAspectRatio, Qt::SmoothTransformation));
  QPixmapCache::insert(key, scaled);
  return scaled;
}

void paintSphere(QPainter& painter, const QImage& picture, const QRectF& square, const QPalette& palette) {
  if (!picture.isNull()) {
    const QPixmap scaled = sphereAtSize(picture, (square.size() * painter.device()->devicePixelRatioF()).toSize());
    painter.drawPixmap(square, scaled, QRectF(scaled.rect()));
    return;
  }
  QColor quiet = palette.color(QPalette::Text);
  quiet.setAlphaF(0.12f);
  painter.setPen(Qt::NoPen);
  painter.setBrush(quiet);
  const double inset = square.width() * 0.1;
  painter.drawEllipse(square.adjusted(inset, inset, -inset, -inset));
}

}  // namespace gonio::widgets
