// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QRectF>

class QPainter;
class QPalette;

namespace gonio::widgets {

/// Draws a small picture of a material, smoothly made smaller; a quiet disc where there is none yet.
void paintSphere(QPainter& painter, const QImage& picture, const QRectF& square, const QPalette& palette);

}  // namespace gonio::widgets
