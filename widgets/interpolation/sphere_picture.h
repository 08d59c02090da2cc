// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QPixmap>
#include <QRectF>

class QPainter;
class QPalette;

namespace gonio::widgets {

/// A picture made smaller, averaged over areas (which drawing a large picture small is not). Remembered while Qt's
/// cache of pixmaps has room, so that a repaint costs no scaling. @param pixels of the device
QPixmap sphereAtSize(const QImage& picture, const QSize& pixels);

/// Draws a small picture of a material, smoothly made smaller; a quiet disc where there is none yet.
void paintSphere(QPainter& painter, const QImage& picture, const QRectF& square, const QPalette& palette);

}  // namespace gonio::widgets
