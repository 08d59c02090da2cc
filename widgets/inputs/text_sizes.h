// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QFont>

namespace gonio::widgets {

/// The type scale of the editor: all texts are of one of three sizes, relative to the font of the application. Headings
/// are bold.
enum class TextSize { small, normal, large };

inline QFont sized(QFont font, TextSize size) {
  constexpr double scales[] = {0.8, 1, 1.5};
  font.setPointSizeF(font.pointSizeF() * scales[int(size)]);
  return font;
}

}  // namespace gonio::widgets
