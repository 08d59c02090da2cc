// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QIcon>

namespace gonio::widgets {

enum class Glyph { reset, collapsed, expanded, search, close, passed, warning, pending, shown, hidden };

/// A small icon drawn in the text colour of the palette at paint time, sharp at any scale and in either theme.
QIcon glyphIcon(Glyph glyph);
/// The same in a pen of the caller's, over a rectangle.
void paintGlyph(QPainter& painter, Glyph glyph, const QRectF& rect);

}  // namespace gonio::widgets
