// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QList>
#include <QPalette>
#include <QString>
#include <QStyleFactory>
#include <QStyleOptionComboBox>

#include "widgets/inputs/plain_text_style.h"

class QApplication;

namespace gonio::app {

/// The style Fusion with the icons of the editor, drawn with one palette object for all widgets of the same colours.
///
/// Qt gives each widget a palette object of its own once the application has set a palette, and Fusion caches what it
/// draws by palette object. Without this style, each widget of each dialog has images of its own in the cache, whose
/// names Qt 6.4 keeps forever.
class SharedPaletteStyle : public widgets::PlainTextStyle {
 public:
  /// @param base drawn with; owned
  explicit SharedPaletteStyle(QStyle* base = QStyleFactory::create(QStringLiteral("Fusion"))) : PlainTextStyle(base) {}

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget = nullptr) const override;
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget = nullptr) const override;
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget = nullptr) const override;
  /// The items of a menu bar are as tall as the tabs in its row.
  QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                         const QWidget* widget) const override;
  int styleHint(StyleHint hint, const QStyleOption* option = nullptr, const QWidget* widget = nullptr,
                QStyleHintReturn* answer = nullptr) const override;
  /// Of message boxes, file dialogs and the titles of docks.
  QIcon standardIcon(StandardPixmap which, const QStyleOption* option = nullptr,
                     const QWidget* widget = nullptr) const override;

 private:
  void sharePalette(const QStyleOption* option) const;
  QStyleOptionComboBox withElidedText(const QStyleOptionComboBox& option, const QWidget* widget) const;

  mutable QList<QPalette> m_palettes;  ///< no two are equal
};

enum class Theme { system, light, dark };

QString themeName(Theme theme);
/// Dark for any other name: the viewport of an editor of materials is never a hole in a light window.
Theme themeByName(const QString& name);

/// Neutral greys, which do not bias the perception of colours, and one accent; text has a contrast of at least 4.5:1.
/// The first call stores the system's theme.
void applyTheme(QApplication& application, Theme theme);

}  // namespace gonio::app
