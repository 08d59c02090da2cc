// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QIcon>

namespace gonio::widgets {

enum class Glyph { reset, collapsed, expanded, search, close };

/// A small icon drawn in the text colour of the palette at paint time, sharp at any scale and in either theme.
QIcon glyphIcon(Glyph glyph);

}  // namespace gonio::widgets
