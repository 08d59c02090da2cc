// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/inputs/plain_text_style.h"

#include <QApplication>
#include <QHeaderView>
#include <QHelpEvent>
#include <QLabel>
#include <QScopedValueRollback>
#include <QToolTip>

namespace gonio::widgets {

namespace {

constexpr const char* richToolTipProperty = "richToolTip";
bool makesRichToolTip = false;  ///< while Qt makes the label of a rich tooltip

struct RichToolTip {
  QString html;
  QRect area;  ///< where it belongs to; null: the whole widget
};

RichToolTip itemToolTip(const QAbstractItemView& view, const QPoint& at) {
  if (const auto* header = qobject_cast<const QHeaderView*>(&view)) {
    if (!header->model()) return {};
    const int section = header->logicalIndexAt(at);
    return {header->model()->headerData(section, header->orientation(), richToolTipRole).toString(), {}};
  }
  const QModelIndex index = view.indexAt(at);
  return {index.data(richToolTipRole).toString(), view.visualRect(index)};
}

RichToolTip richToolTip(const QWidget& widget, const QPoint& at) {
  const auto* view = qobject_cast<const QAbstractItemView*>(widget.parentWidget());
  if (view && view->viewport() == &widget) return itemToolTip(*view, at);
  // Plain text that was set later has replaced it.
  const QString html = widget.property(richToolTipProperty).toString();
  return {html == widget.toolTip() ? html : QString(), {}};
}

/// Qt puts the next tooltip into the label of the last one if that is still shown. A hidden one is replaced by a new
/// label, whose format polish() sets.
void hideToolTipUnless(Qt::TextFormat format) {
  for (QWidget* window : QApplication::topLevelWidgets()) {
    auto* label = qobject_cast<QLabel*>(window);
    if (label && label->inherits("QTipLabel") && label->textFormat() != format) label->hide();
  }
}

}  // namespace

void PlainTextStyle::polish(QWidget* widget) {
  QProxyStyle::polish(widget);
  auto* label = qobject_cast<QLabel*>(widget);
  if (!label || label->textFormat() != Qt::AutoText) return;
  label->setTextFormat(makesRichToolTip && label->inherits("QTipLabel") ? Qt::RichText : Qt::PlainText);
}

void PlainTextStyle::polish(QApplication* application) {
  QProxyStyle::polish(application);
  application->installEventFilter(this);
}

bool PlainTextStyle::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ToolTip || !watched->isWidgetType()) return false;
  auto& widget = *static_cast<QWidget*>(watched);
  const auto& help = *static_cast<QHelpEvent*>(event);
  const RichToolTip tip = richToolTip(widget, help.pos());
  if (tip.html.isEmpty()) {
    hideToolTipUnless(Qt::PlainText);
    return false;
  }
  showRichToolTip(help.globalPos(), tip.html, &widget, tip.area);
  return true;
}

void setRichToolTip(QWidget& widget, const QString& html) {
  widget.setProperty(richToolTipProperty, html);
  widget.setToolTip(html);
}

void showRichToolTip(const QPoint& globalPosition, const QString& html, QWidget* widget, const QRect& area) {
  hideToolTipUnless(Qt::RichText);
  const QScopedValueRollback<bool> making(makesRichToolTip, true);
  QToolTip::showText(globalPosition, html, widget, area);
}

}  // namespace gonio::widgets
