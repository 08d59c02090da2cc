// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QIcon>
#include <QPixmap>

namespace gonio::widgets {

enum class Glyph {
  reset,
  collapsed,
  expanded,
  search,
  close,
  passed,
  warning,
  note,
  pending,
  shown,
  hidden,
  sliders,
  curves,
  blend
};

/// A small icon, drawn in the palette's text colour when it is painted, so that it is sharp at any scale and follows
/// the theme.
QIcon glyphIcon(Glyph glyph);
/// The same with the painter's pen, in a rectangle.
void paintGlyph(QPainter& painter, Glyph glyph, const QRectF& rect);

/// A pixmap scaled to a size with the same aspect ratio, averaged over areas (unlike painting a large pixmap small).
/// Cached, so that it can be called in every paint event.
QPixmap scaledPixmap(const QPixmap& pixmap, const QSize& size);

}  // namespace gonio::widgets
