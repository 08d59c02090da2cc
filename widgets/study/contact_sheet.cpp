// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/study/contact_sheet.h"

#include <QBuffer>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <algorithm>

#include "widgets/inputs/icons.h"
#include "widgets/preview/false_colour_legend.h"

namespace gonio::widgets {

namespace {
constexpr int textLines = 5, nameLines = 2, maxSelected = 2, minTileSide = 48;
}

/// Where things stand, in pixels of the drawing.
struct ContactSheet::Layout {
  int side, columns, gap, line, tileHeight, count;
  bool scale;

  QRect tile(int index) const {
    return {gap + (index % columns) * (side + gap), gap + (index / columns) * (tileHeight + gap), side, tileHeight};
  }
  int rows() const { return (count + columns - 1) / columns; }
  int tilesBottom() const { return gap + rows() * (tileHeight + gap); }
  QSize size() const { return {gap + columns * (side + gap), tilesBottom() + (scale ? 3 * line : 0)}; }
};

ContactSheet::ContactSheet(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
  setAccessibleName(tr("Contact sheet"));
}

ContactSheet::Layout ContactSheet::layoutFor(int tileSide, int columns, const QFont& font) const {
  const int line = QFontMetrics(font).lineSpacing();
  const bool maps = m_mapsShown && m_range > 0;
  return {.side = tileSide,
          .columns = std::max(1, columns),
          .gap = line,
          .line = line,
          .tileHeight = (maps ? 2 : 1) * tileSide + textLines * line,
          .count = int(m_tiles.size()),
          .scale = maps};
}

ContactSheet::Layout ContactSheet::layoutIn(int width) const {
  const int gap = fontMetrics().lineSpacing();
  if (m_columns == 0) return layoutFor(m_side, (width - gap) / (m_side + gap), font());
  return layoutFor(std::clamp((width - gap) / m_columns - gap, minTileSide, m_side), m_columns, font());
}

void ContactSheet::setTiles(std::vector<SheetTile> tiles) {
  const bool sameCount = tiles.size() == m_tiles.size();
  m_tiles = std::move(tiles);
  if (!sameCount) {
    m_selected.clear();
    m_current = 0;
    Q_EMIT selectionChanged();
  }
  updateGeometry();
  update();
}

void ContactSheet::setRange(double range) {
  m_range = range;
  updateGeometry();
  update();
}

void ContactSheet::setMapsShown(bool shown) {
  m_mapsShown = shown;
  updateGeometry();
  update();
}

void ContactSheet::setTileSide(int pixels) {
  m_side = pixels;
  updateGeometry();
  update();
}

void ContactSheet::setColumns(int columns) {
  m_columns = columns;
  updateGeometry();
  update();
}

void ContactSheet::toggle(int tile) {
  if (tile < 0 || tile >= int(m_tiles.size())) return;
  m_current = tile;
  if (std::erase(m_selected, tile) == 0) m_selected.push_back(tile);
  if (m_selected.size() > maxSelected) m_selected.erase(m_selected.begin());
  update();
  Q_EMIT selectionChanged();
}

namespace {

QFont fontFor(QFont font, int tileSide) {
  font.setPixelSize(std::max(8, tileSide / 14));
  return font;
}

/// As much of a text as has room in some lines; its ends distinguish it, so the middle is left out.
QString fitting(const QPainter& painter, const QString& text, int width, int lines) {
  constexpr double used = 0.85;  // words leave some of each line empty
  return painter.fontMetrics().elidedText(text, Qt::ElideMiddle, int(used * lines * width));
}

}  // namespace

QByteArray ContactSheet::pdf(int tileSide, int columns) const {
  const QFont large = fontFor(font(), tileSide);
  const Layout layout = layoutFor(tileSide, columns, large);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  constexpr int pointsPerInch = 72;
  writer.setResolution(pointsPerInch);
  writer.setPageSize(QPageSize(QSizeF(layout.size()), QPageSize::Point));
  writer.setPageMargins({});
  QPainter painter(&writer);
  painter.setFont(large);
  draw(painter, layout, Qt::black);
  painter.end();
  return bytes;
}

QImage ContactSheet::picture(int tileSide, int columns) const {
  const QFont large = fontFor(font(), tileSide);
  const Layout layout = layoutFor(tileSide, columns, large);
  QImage image(layout.size(), QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setFont(large);
  draw(painter, layout, Qt::black);
  return image;
}

int ContactSheet::heightForWidth(int width) const { return layoutIn(width).size().height(); }

QSize ContactSheet::sizeHint() const { return layoutFor(m_side, 4, font()).size(); }
QSize ContactSheet::minimumSizeHint() const {
  const Layout narrowest = m_columns == 0 ? layoutFor(m_side, 1, font()) : layoutFor(minTileSide, m_columns, font());
  return {narrowest.size().width(), heightForWidth(width())};
}

void ContactSheet::draw(QPainter& painter, const Layout& layout, const QColor& text) const {
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.setPen(text);
  for (std::size_t i = 0; i < m_tiles.size(); ++i) drawTile(painter, layout, i);
  if (layout.scale) drawScale(painter, layout);
}

void ContactSheet::drawTile(QPainter& painter, const Layout& layout, std::size_t index) const {
  const SheetTile& tile = m_tiles[index];
  const QRect place = layout.tile(int(index));
  const auto drawSquare = [&](const QPixmap& image, int top) {
    const QRect square(place.left(), top, layout.side, layout.side);
    painter.drawPixmap(square, scaledPixmap(image, square.size() * painter.device()->devicePixelRatioF()));
  };
  if (tile.picture.isNull())
    drawPlaceholder(painter, QRect(place.topLeft(), QSize(layout.side, layout.side)),
                    tile.note.isEmpty() ? tr("Rendering...") : tile.note);
  else
    drawSquare(tile.picture, place.top());
  if (layout.scale && !tile.map.isNull()) drawSquare(tile.map, place.top() + layout.side);
  const QFont plain = painter.font();
  QFont bold = plain;
  bold.setBold(true);
  painter.setFont(bold);
  const int textTop = place.bottom() + 1 - textLines * layout.line;
  QRect drawn;
  painter.drawText(QRect(place.left(), textTop, layout.side, nameLines * layout.line),
                   Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap,
                   fitting(painter, tile.name, layout.side, nameLines), &drawn);
  painter.setFont(plain);
  painter.drawText(QRect(place.left(), drawn.bottom() + 1, layout.side, place.bottom() - drawn.bottom()),
                   Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap,
                   fitting(painter, tile.numbers, layout.side, textLines - nameLines));
}

void ContactSheet::drawPlaceholder(QPainter& painter, const QRect& square, const QString& note) const {
  painter.save();
  painter.setOpacity(0.6);
  painter.setPen(QPen(painter.pen().color(), 1, Qt::DashLine));
  painter.setBrush(Qt::NoBrush);
  const int margin = square.width() / 8;
  painter.drawEllipse(square.adjusted(margin, margin, -margin, -margin));
  painter.drawText(square, Qt::AlignCenter | Qt::TextWordWrap, note);
  painter.restore();
}

void ContactSheet::drawScale(QPainter& painter, const Layout& layout) const {
  const QRect bar(layout.gap, layout.tilesBottom(), std::min(4 * layout.side, layout.size().width() - 2 * layout.gap),
                  layout.line / 2);
  drawColourBar(painter, bar, DifferenceKind::absolute);
  const QRect text(bar.left(), bar.bottom() + 2, bar.width(), layout.line);
  painter.drawText(text, Qt::AlignLeft, QStringLiteral("0"));
  const QString largest = tr("≥ %1").arg(differenceNumber(DifferenceKind::absolute, m_range));
  painter.drawText(text, Qt::AlignRight, largest);
  // Between the numbers where it has room, else below them.
  const QString title = differenceTitle(DifferenceKind::absolute);
  const QFontMetrics metrics = painter.fontMetrics();
  if (metrics.horizontalAdvance(title) + 2 * metrics.horizontalAdvance(largest + QStringLiteral("  ")) <= bar.width())
    return painter.drawText(text, Qt::AlignHCenter, title);
  const int room = layout.size().width() - 2 * layout.gap;
  painter.drawText(QRect(layout.gap, text.bottom() + 1, room, layout.line), Qt::AlignLeft,
                   metrics.elidedText(title, Qt::ElideRight, room));
}

void ContactSheet::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const Layout layout = layoutIn(width());
  painter.setRenderHint(QPainter::Antialiasing);
  QColor fill = palette().color(QPalette::Highlight);
  fill.setAlphaF(0.25f);
  for (const int tile : m_selected) {
    painter.setPen(palette().color(QPalette::Highlight));
    painter.setBrush(fill);
    painter.drawRoundedRect(layout.tile(tile).adjusted(-4, -4, 4, 4), 5, 5);
  }
  if (hasFocus() && !m_tiles.empty()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    painter.drawRoundedRect(layout.tile(m_current).adjusted(-5, -5, 5, 5), 5, 5);
  }
  draw(painter, layout, palette().color(QPalette::Text));
}

void ContactSheet::mousePressEvent(QMouseEvent* event) {
  const Layout layout = layoutIn(width());
  for (int i = 0; i < layout.count; ++i)
    if (layout.tile(i).contains(event->pos())) return toggle(i);
}

void ContactSheet::keyPressEvent(QKeyEvent* event) {
  const int columns = layoutIn(width()).columns;
  const auto go = [&](int steps) {
    m_current = std::clamp(m_current + steps, 0, std::max(0, int(m_tiles.size()) - 1));
    update();
  };
  switch (event->key()) {
    case Qt::Key_Left:
      return go(-1);
    case Qt::Key_Right:
      return go(1);
    case Qt::Key_Up:
      return go(-columns);
    case Qt::Key_Down:
      return go(columns);
    case Qt::Key_Space:
      return toggle(m_current);
    default:
      QWidget::keyPressEvent(event);
  }
}

void ContactSheet::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  updateGeometry();
}

}  // namespace gonio::widgets

#include "moc_contact_sheet.cpp"
