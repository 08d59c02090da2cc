// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/shared_palette_style.h"

#include <QStyleOption>
#include <algorithm>

namespace gonio::app {

void SharedPaletteStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                       const QWidget* widget) const {
  sharePalette(option);
  PlainTextStyle::drawPrimitive(element, option, painter, widget);
}

void SharedPaletteStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                                     const QWidget* widget) const {
  sharePalette(option);
  PlainTextStyle::drawControl(element, option, painter, widget);
}

void SharedPaletteStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                            QPainter* painter, const QWidget* widget) const {
  sharePalette(option);
  PlainTextStyle::drawComplexControl(control, option, painter, widget);
}

/// Replaces the palette by an equal one. An option cannot be copied, since only the style that reads it knows its type.
void SharedPaletteStyle::sharePalette(const QStyleOption* option) const {
  if (!option) return;
  constexpr qsizetype many = 50;  // themes and classes of widgets need fewer than ten
  QPalette& palette = const_cast<QStyleOption*>(option)->palette;
  const auto same = std::ranges::find(m_palettes, palette);
  if (same == m_palettes.end()) {
    if (m_palettes.size() >= many) m_palettes.clear();
    m_palettes << palette;
    return;
  }
  const QPalette::ColorGroup group = palette.currentColorGroup();
  palette = *same;
  palette.setCurrentColorGroup(group);
}

}  // namespace gonio::app
