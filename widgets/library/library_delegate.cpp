// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/library/library_delegate.h"

#include <QPainter>
#include <QPixmapCache>

#include "widgets/library/library_model.h"

namespace gonio::widgets {

namespace {
constexpr int margin = 4, labelLines = 2;

void paintPlaceholder(QPainter& painter, const QRectF& area, QColor colour, bool failed) {
  colour.setAlphaF(0.12f);
  painter.setBrush(colour);
  painter.setPen(failed ? QPen(colour.lighter(), 1, Qt::DashLine) : QPen(Qt::NoPen));
  const double inset = area.width() * 0.1;
  painter.drawEllipse(area.adjusted(inset, inset, -inset, -inset));
}
/// Averaged over areas, which drawing a large pixmap small is not, and kept.
QPixmap scaled(const QPixmap& pixmap, const QSize& size) {
  const QString key = QStringLiteral("library/%1/%2").arg(pixmap.cacheKey()).arg(size.width());
  QPixmap result;
  if (!QPixmapCache::find(key, &result)) {
    result = pixmap.scaled(size, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QPixmapCache::insert(key, result);
  }
  return result;
}

/// Lets "blue-metallic-paint" break after a hyphen, and "ch_mint_rgb" after an underscore.
QString breakable(QString name) {
  const QChar here(0x200b);
  return name.replace('-', QStringLiteral("-") + here).replace('_', QStringLiteral("_") + here);
}

}  // namespace

QSize LibraryDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
  return {m_tile + 2 * margin, m_tile + labelLines * option.fontMetrics.height() + 3 * margin};
}

void LibraryDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  painter->save();
  painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  const QRectF tile = QRectF(option.rect).adjusted(1.5, 1.5, -1.5, -1.5);
  const bool selected = option.state & QStyle::State_Selected, hovered = option.state & QStyle::State_MouseOver;
  const bool focused = option.state & QStyle::State_HasFocus;
  const QColor accent = option.palette.color(QPalette::Highlight), text = option.palette.color(QPalette::Text);
  if (selected || hovered) {
    QColor fill = selected ? accent : text;
    fill.setAlphaF(selected ? 0.28f : 0.07f);
    painter->setPen(Qt::NoPen);
    painter->setBrush(fill);
    painter->drawRoundedRect(tile, 5, 5);
  }
  if (focused || selected) {
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(accent, focused ? 2 : 1));
    painter->drawRoundedRect(tile, 5, 5);
  }
  const QRect picture(option.rect.left() + (option.rect.width() - m_tile) / 2, option.rect.top() + margin, m_tile,
                      m_tile);
  const QPixmap pixmap = index.data(Qt::DecorationRole).value<QPixmap>();
  if (pixmap.isNull())
    paintPlaceholder(*painter, picture, text, !index.data(LibraryModel::FailureRole).toString().isEmpty());
  else
    painter->drawPixmap(picture, scaled(pixmap, QSize(m_tile, m_tile) * painter->device()->devicePixelRatioF()));

  const QRect label(option.rect.left() + margin / 2, picture.bottom() + margin, option.rect.width() - margin,
                    labelLines * option.fontMetrics.height());
  painter->setPen(text);
  painter->setFont(option.font);
  painter->drawText(label, Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, breakable(index.data().toString()));
  painter->restore();
}

}  // namespace gonio::widgets

#include "moc_library_delegate.cpp"
