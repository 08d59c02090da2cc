// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyleOption>
#include <QVariant>
#include <algorithm>

#include "widgets/inputs/icons.h"

namespace gonio::app {

void SharedPaletteStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                       const QWidget* widget) const {
  sharePalette(option);
  PlainTextStyle::drawPrimitive(element, option, painter, widget);
}

void SharedPaletteStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                                     const QWidget* widget) const {
  sharePalette(option);
  if (const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option); box && element == CE_ComboBoxLabel) {
    const QStyleOptionComboBox elided = withElidedText(*box, widget);
    return PlainTextStyle::drawControl(element, &elided, painter, widget);
  }
  PlainTextStyle::drawControl(element, option, painter, widget);
}

/// Fusion cuts a name that the box has no room for.
QStyleOptionComboBox SharedPaletteStyle::withElidedText(const QStyleOptionComboBox& option,
                                                        const QWidget* widget) const {
  constexpr int margins = 2, iconMargin = 4;  // of Fusion
  const int icon = option.currentIcon.isNull() || option.iconSize.isEmpty() ? 0 : option.iconSize.width() + iconMargin;
  const QRect field = subControlRect(CC_ComboBox, &option, SC_ComboBoxEditField, widget);
  QStyleOptionComboBox elided = option;
  elided.currentText =
      option.fontMetrics.elidedText(option.currentText, Qt::ElideRight, field.width() - margins - icon);
  return elided;
}

void SharedPaletteStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                            QPainter* painter, const QWidget* widget) const {
  sharePalette(option);
  PlainTextStyle::drawComplexControl(control, option, painter, widget);
}

QSize SharedPaletteStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                                           const QWidget* widget) const {
  QSize result = PlainTextStyle::sizeFromContents(type, option, size, widget);
  if (type == CT_MenuBarItem) result.rheight() += option->fontMetrics.height() / 2;
  return result;
}

int SharedPaletteStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                                  QStyleHintReturn* answer) const {
  // The texts of the buttons say what they do.
  if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
  return PlainTextStyle::styleHint(hint, option, widget, answer);
}

QIcon SharedPaletteStyle::standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const {
  static const std::pair<StandardPixmap, const char*> icons[] = {{SP_MessageBoxInformation, "note"},
                                                                 {SP_MessageBoxWarning, "warning"},
                                                                 {SP_MessageBoxCritical, "warning"},
                                                                 {SP_MessageBoxQuestion, "help"},
                                                                 {SP_TitleBarCloseButton, "close"},
                                                                 {SP_DockWidgetCloseButton, "close"},
                                                                 {SP_LineEditClearButton, "close"},
                                                                 {SP_TitleBarNormalButton, "float"},
                                                                 {SP_FileDialogToParent, "up"},
                                                                 {SP_FileDialogBack, "back"},
                                                                 {SP_ArrowBack, "back"},
                                                                 {SP_ArrowForward, "forward"},
                                                                 {SP_FileDialogNewFolder, "new-folder"},
                                                                 {SP_FileDialogListView, "target-list"},
                                                                 {SP_FileDialogDetailedView, "details"},
                                                                 {SP_DirIcon, "open"},
                                                                 {SP_DirClosedIcon, "open"},
                                                                 {SP_DirOpenIcon, "open"},
                                                                 {SP_DirLinkIcon, "open"},
                                                                 {SP_DirHomeIcon, "home"},
                                                                 {SP_FileIcon, "file"},
                                                                 {SP_FileLinkIcon, "file"},
                                                                 {SP_ComputerIcon, "drive"},
                                                                 {SP_DriveHDIcon, "drive"}};
  const auto found = std::ranges::find(icons, which, &std::pair<StandardPixmap, const char*>::first);
  return found == std::end(icons) ? PlainTextStyle::standardIcon(which, option, widget)
                                  : widgets::themedIcon(QString::fromLatin1(found->second));
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

namespace {

struct Tones {
  const char *window, *base, *alternate, *button, *text, *quiet, *light, *mid, *dark, *accent, *onAccent, *link;
};
constexpr Tones darkTones = {"#2b2b2b", "#212121", "#333333", "#3a3a3a", "#e4e4e4", "#a9a9a9",
                             "#5a5a5a", "#4a4a4a", "#191919", "#5fa3dd", "#101010", "#7fb8ea"};
constexpr Tones lightTones = {"#ededed", "#fafafa", "#e2e2e2", "#f4f4f4", "#1c1c1c", "#5c5c5c",
                              "#ffffff", "#b4b4b4", "#9a9a9a", "#2a6cab", "#ffffff", "#1d5a96"};

QPalette paletteOf(const Tones& tones) {
  QPalette palette;
  palette.setColor(QPalette::Window, tones.window);
  palette.setColor(QPalette::WindowText, tones.text);
  palette.setColor(QPalette::Base, tones.base);
  palette.setColor(QPalette::AlternateBase, tones.alternate);
  palette.setColor(QPalette::ToolTipBase, tones.alternate);
  palette.setColor(QPalette::ToolTipText, tones.text);
  palette.setColor(QPalette::Text, tones.text);
  palette.setColor(QPalette::PlaceholderText, tones.quiet);
  palette.setColor(QPalette::Button, tones.button);
  palette.setColor(QPalette::ButtonText, tones.text);
  palette.setColor(QPalette::BrightText, tones.onAccent);
  palette.setColor(QPalette::Light, tones.light);
  palette.setColor(QPalette::Midlight, tones.light);
  palette.setColor(QPalette::Mid, tones.mid);
  palette.setColor(QPalette::Dark, tones.dark);
  palette.setColor(QPalette::Shadow, tones.dark);
  palette.setColor(QPalette::Highlight, tones.accent);
  palette.setColor(QPalette::HighlightedText, tones.onAccent);
  palette.setColor(QPalette::Link, tones.link);
  palette.setColor(QPalette::LinkVisited, tones.link);
  QColor disabled(tones.text);
  disabled.setAlphaF(0.45f);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, disabled);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, tones.mid);
  return palette;
}

/// Qt 6.4 does not report the colour scheme; the palette that the platform theme gave does.
bool systemIsDark() {
  static const bool dark = QApplication::palette().color(QPalette::Window).lightness() < 128;
  return dark;
}

// Only what a palette cannot say. Lengths in ex and em follow the font.
constexpr const char* styleSheet = R"(
QToolButton#sectionHeader { padding: 0.5ex 0.5ex; border: none; border-radius: 3px; background: palette(alternate-base); }
QToolButton#sectionHeader:focus { border: 2px solid palette(highlight); }
QToolButton#kind { padding: 0.9ex 1ex; border: 1px solid palette(mid); border-radius: 4px; background: palette(button); }
QToolButton#kind:hover { background: palette(mid); }
QToolButton#kind:checked { border-color: palette(highlight); border-bottom: 3px solid palette(highlight); background: palette(mid); }
QToolButton#kind:focus { border-color: palette(highlight); }
QDockWidget::title { padding: 0.7ex 1ex; background: palette(window); text-align: left; }
QMainWindow::separator { width: 5px; height: 5px; background: palette(window); }
QLabel#groupTitle { margin-top: 0.8ex; }
QFrame#messageBar { border-left: 3px solid palette(highlight); }
QStatusBar::item { border: none; }
QPushButton:focus, QComboBox:focus, QLineEdit:focus, QListView:focus { outline: none; }
)";

}  // namespace

QString themeName(Theme theme) {
  return theme == Theme::light  ? QStringLiteral("light")
         : theme == Theme::dark ? QStringLiteral("dark")
                                : QStringLiteral("system");
}

Theme themeByName(const QString& name) {
  return name == "light" ? Theme::light : name == "system" ? Theme::system : Theme::dark;
}

void applyTheme(QApplication& application, Theme theme) {
  const bool systemDark = systemIsDark();  // before the palette is replaced
  const bool dark = theme == Theme::dark || (theme == Theme::system && systemDark);
  const char* const shownKey = "isThemeDark";
  const QVariant shown = application.property(shownKey);
  if (shown == QVariant(dark)) return;
  application.setProperty(shownKey, dark);
  if (!shown.isValid()) application.setStyle(new SharedPaletteStyle);
  application.setPalette(paletteOf(dark ? darkTones : lightTones));
  // Fusion outlines boxes and radio buttons, and fills them when they are chosen, in tones that a dark window swallows.
  QPalette indicators = application.palette();
  if (dark) {
    indicators.setColor(QPalette::Base, darkTones.mid);
    indicators.setColor(QPalette::Text, Qt::white);
  }
  application.setPalette(indicators, "QCheckBox");
  application.setPalette(indicators, "QRadioButton");
  application.setStyleSheet(QString::fromLatin1(styleSheet));
}

}  // namespace gonio::app
