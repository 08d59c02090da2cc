// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QIcon>
#include <QPixmap>

namespace gonio::widgets {

/// An icon of resources/icons by the name of its file. It is drawn in the palette's text colour when it is painted
/// (that of selected text in a selected row), so that it is sharp at any scale and follows the theme. Precondition:
/// hasIcon(name).
QIcon themedIcon(const QString& name);
/// The same with the painter's pen, in a rectangle.
void paintIcon(QPainter& painter, const QString& name, const QRectF& rect);
bool hasIcon(const QString& name);

/// A pixmap scaled to a size with the same aspect ratio, averaged over areas (unlike painting a large pixmap small).
/// Cached, so that it can be called in every paint event.
QPixmap scaledPixmap(const QPixmap& pixmap, const QSize& size);

}  // namespace gonio::widgets
