// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/interpolation/sphere_picture.h"

#include <QPainter>
#include <QPalette>

namespace gonio::widgets {

void paintSphere(QPainter& painter, const QImage& picture, const QRectF& square, const QPalette& palette) {
  if (!picture.isNull()) {
    // Averaged over areas, which drawing a large picture small is not.
    const QSize pixels = (square.size() * painter.device()->devicePixelRatioF()).toSize();
    painter.drawImage(square, picture.scaled(pixels, Qt::KeepAspectRatio, Qt::SmoothTransformation));
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
