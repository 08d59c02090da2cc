// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QProxyStyle>
#include <QRect>

namespace gonio::widgets {

/// A style in which text is never taken for HTML because it looks like HTML.
///
/// Qt guesses the format of labels (also those of message boxes) and of tooltips. Most of them contain words of files,
/// which could then show headings, load images, or block the window with an image that is a FIFO. Here a label shows
/// plain text unless its format was set to Qt::RichText, and a tooltip unless it was set by setRichToolTip() or
/// richToolTipRole.
class PlainTextStyle : public QProxyStyle {
 public:
  using QProxyStyle::polish;
  using QProxyStyle::QProxyStyle;

  void polish(QWidget* widget) override;
  /// Starts to show rich tooltips.
  void polish(QApplication* application) override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

/// Role of item models for a tooltip in HTML; Qt::ToolTipRole is plain text.
inline constexpr int richToolTipRole = Qt::UserRole + 1000;

/// Gives a widget a tooltip in HTML. Words of files in it must be escaped. Empty: no tooltip.
void setRichToolTip(QWidget& widget, const QString& html);

/// Shows a tooltip in HTML, like QToolTip::showText().
void showRichToolTip(const QPoint& globalPosition, const QString& html, QWidget* widget, const QRect& area = {});

}  // namespace gonio::widgets
