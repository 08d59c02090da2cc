// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/library/library_delegate.h"

#include <QListView>
#include <QPainter>
#include <cmath>

#include "core/math/types.h"
#include "widgets/inputs/scaled_pixmap.h"
#include "widgets/library/library_model.h"

namespace gonio::widgets {

namespace {
constexpr int margin = 4, labelLines = 2;

/// A grey disc of a picture that is still to be made; crossed out where the file cannot be read.
void paintPlaceholder(QPainter& painter, const QRectF& area, QColor colour, bool failed) {
  colour.setAlphaF(0.12f);
  painter.setBrush(colour);
  painter.setPen(Qt::NoPen);
  const double inset = area.width() * 0.1;
  painter.drawEllipse(area.adjusted(inset, inset, -inset, -inset));
  if (!failed) return;
  painter.setPen(QPen(QColor(200, 60, 50), std::max(2.0, area.width() / 32), Qt::SolidLine, Qt::RoundCap));
  const double reach = area.width() * 0.16;
  const QPointF middle = area.center(), along(reach, reach), across(reach, -reach);
  painter.drawLine(middle - along, middle + along);
  painter.drawLine(middle - across, middle + across);
}

/// Lets "blue-metallic-paint" break after a hyphen, and "ch_mint_rgb" after an underscore.
QString breakable(QString name) {
  const QChar here(0x200b);
  return name.replace('-', QStringLiteral("-") + here).replace('_', QStringLiteral("_") + here);
}

void paintHeading(QPainter& painter, const QStyleOptionViewItem& option, const QString& title) {
  QFont font = option.font;
  font.setBold(true);
  painter.setFont(font);
  painter.setPen(option.palette.color(QPalette::Text));
  const QRect area = option.rect.adjusted(margin, 0, -margin, -margin / 2);
  painter.drawText(area, Qt::AlignLeft | Qt::AlignVCenter,
                   QFontMetrics(font).elidedText(title, Qt::ElideRight, area.width()));
  QColor line = option.palette.color(QPalette::Text);
  line.setAlphaF(0.25f);
  painter.setPen(line);
  painter.drawLine(area.bottomLeft(), area.bottomRight());
}

/// A text on a ground of its own, legible on any picture.
void paintPill(QPainter& painter, const QStyleOptionViewItem& option, const QRect& pill, const QFont& font,
               const QString& text) {
  // Grey against the list: in the list's own colour the text would look like a hole in the picture.
  QColor ground = option.palette.color(QPalette::Window).darker(108);
  ground.setAlphaF(0.92f);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ground);
  painter.drawRoundedRect(pill, pill.height() / 2.0, pill.height() / 2.0);
  painter.setPen(option.palette.color(QPalette::Text));
  painter.setFont(font);
  painter.drawText(pill, Qt::AlignCenter, text);
}

/// A word at the lower edge of the picture.
void paintBadge(QPainter& painter, const QStyleOptionViewItem& option, const QRect& picture, const QString& badge) {
  if (badge.isEmpty()) return;
  QFont font = option.font;
  font.setPointSizeF(font.pointSizeF() * 0.78);
  const QFontMetrics metrics(font);
  const QString text = metrics.elidedText(badge, Qt::ElideRight, picture.width() - 2 * margin);
  QRect pill(0, 0, metrics.horizontalAdvance(text) + 2 * margin, metrics.height());
  pill.moveCenter({picture.center().x(), picture.bottom() - pill.height() / 2});
  paintPill(painter, option, pill, font, text);
}

/// "4" and a star in the upper left corner of the picture.
void paintRating(QPainter& painter, const QStyleOptionViewItem& option, const QRect& picture, int rating) {
  const QString text = QString::number(rating) + QChar(0x2605);
  const QSize size(option.fontMetrics.horizontalAdvance(text) + margin, option.fontMetrics.height());
  paintPill(painter, option, {picture.topLeft(), size}, option.font, text);
}

/// A star in the upper right corner of the picture.
void paintStar(QPainter& painter, const QStyleOptionViewItem& option, const QRect& picture) {
  const double radius = option.fontMetrics.height() * 0.45;
  const QPointF middle(picture.right() - radius - margin, picture.top() + radius + margin);
  QPolygonF star;
  constexpr double inner = 0.42;
  for (int i = 0; i < 10; ++i) {
    const double angle = i * pi / 5, reach = radius * (i % 2 ? inner : 1);
    star << middle + reach * QPointF(std::sin(angle), -std::cos(angle));
  }
  painter.setPen(QPen(option.palette.color(QPalette::Base), 1.5));
  painter.setBrush(QColor(235, 170, 30));
  painter.drawPolygon(star);
}

}  // namespace

QSize LibraryDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  if (index.data(LibraryModel::HeadingRole).toBool()) {
    // A row of its own: as wide as the view.
    const auto* view = qobject_cast<const QListView*>(option.widget);
    const int width = view ? view->viewport()->width() - 2 * view->spacing() - 1 : m_tile;
    return {width, option.fontMetrics.height() + 3 * margin};
  }
  return {m_tile + 2 * margin, m_tile + labelLines * option.fontMetrics.height() + 3 * margin};
}

void LibraryDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  painter->save();
  painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  if (index.data(LibraryModel::HeadingRole).toBool())
    paintHeading(*painter, option, index.data().toString());
  else
    paintTile(painter, option, index);
  painter->restore();
}

void LibraryDelegate::paintTile(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
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
  const bool failed = !index.data(LibraryModel::FailureRole).toString().isEmpty();
  if (pixmap.isNull())
    paintPlaceholder(*painter, picture, text, failed);
  else
    painter->drawPixmap(picture, scaledPixmap(pixmap, QSize(m_tile, m_tile) * painter->device()->devicePixelRatioF()));

  const QRect label(option.rect.left() + margin / 2, picture.bottom() + margin, option.rect.width() - margin,
                    labelLines * option.fontMetrics.height());
  painter->setPen(text);
  painter->setFont(option.font);
  painter->drawText(label, Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, breakable(index.data().toString()));
  paintBadge(*painter, option, picture,
             index.data(failed ? LibraryModel::FailureBadgeRole : LibraryModel::BadgeRole).toString());
  if (index.data(LibraryModel::FavouriteRole).toBool()) paintStar(*painter, option, picture);
  if (const int rating = index.data(LibraryModel::RatingRole).toInt(); rating > 0)
    paintRating(*painter, option, picture, rating);
}

}  // namespace gonio::widgets

#include "moc_library_delegate.cpp"
