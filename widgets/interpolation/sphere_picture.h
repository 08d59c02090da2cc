// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QPixmap>
#include <QRectF>

class QPainter;
class QPalette;

namespace gonio::widgets {

/// A picture scaled down, averaged over areas (unlike painting a large picture small). Stored in Qt's pixmap cache, so
/// that repaints need no scaling. @param pixels size in device pixels.
QPixmap sphereAtSize(const QImage& picture, const QSize& pixels);

/// Draws a small picture of a material, scaled smoothly, or a placeholder disc if there is none.
void paintSphere(QPainter& painter, const QImage& picture, const QRectF& square, const QPalette& palette);

}  // namespace gonio::widgets
