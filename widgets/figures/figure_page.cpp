// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/figures/figure_page.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace gonio::widgets {

namespace {

constexpr int pageMargin = 12;         ///< around the page, pixels
constexpr double emptyAspect = 0.75;   ///< height / width before there is a page
constexpr double minDrawnSide = 0.02;  ///< of a drawn square, in picture sides; a smaller one is a click

/// The square from a corner toward a point, inside the unit square.
QRectF squareBetween(const QPointF& start, const QPointF& end) {
  const bool leftward = end.x() < start.x(), upward = end.y() < start.y();
  const double wanted = std::max(std::abs(end.x() - start.x()), std::abs(end.y() - start.y()));
  const double length = std::min({wanted, leftward ? start.x() : 1 - start.x(), upward ? start.y() : 1 - start.y()});
  return {leftward ? start.x() - length : start.x(), upward ? start.y() - length : start.y(), length, length};
}

QRectF movedBy(const QRectF& square, const QPointF& by) {
  const double most = 1 - square.width();
  return {std::clamp(square.x() + by.x(), 0.0, most), std::clamp(square.y() + by.y(), 0.0, most), square.width(),
          square.width()};
}

}  // namespace

FigurePage::FigurePage(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Figure preview"));
  setBackgroundRole(QPalette::Dark);
  setAutoFillBackground(true);
  setMouseTracking(true);
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void FigurePage::setPage(const QImage& page, std::vector<QRectF> pictures) {
  m_page = page;
  m_pictures = std::move(pictures);
  if (m_drag && m_drag->picture >= m_pictures.size()) m_drag.reset();
  updateGeometry();
  update();
  reportWidth();
}

void FigurePage::setMessage(const QString& message) {
  m_message = message;
  setAccessibleDescription(message);
  updateGeometry();
  update();
}

void FigurePage::setSquare(const std::optional<QRectF>& square) {
  m_square = square;
  update();
}

void FigurePage::setWhole(bool whole) {
  m_whole = whole;
  updateGeometry();
  update();
  reportWidth();
}

double FigurePage::shownWidth(int width) const {
  const double all = width - 2 * pageMargin;
  if (!m_whole || m_page.isNull() || !parentWidget()) return all;
  return std::min(all, double(parentWidget()->height() - 2 * pageMargin) * m_page.width() / m_page.height());
}

int FigurePage::pageWidth() const { return std::max(1, int(shownWidth(width()) * devicePixelRatioF())); }

/// The height of a page in pixels is rounded, so a difference of one or two pixels is not a new width.
void FigurePage::reportWidth() {
  constexpr int tolerance = 2;
  if (std::abs(pageWidth() - m_reportedWidth) <= tolerance) return;
  m_reportedWidth = pageWidth();
  Q_EMIT resized();
}

int FigurePage::heightForWidth(int width) const {
  const double aspect =
      m_page.isNull() || !m_message.isEmpty() ? emptyAspect : double(m_page.height()) / m_page.width();
  return int(std::ceil(shownWidth(width) * aspect)) + 2 * pageMargin;
}

QSize FigurePage::sizeHint() const { return {640, heightForWidth(640)}; }
QSize FigurePage::minimumSizeHint() const { return {240, heightForWidth(width())}; }

QRectF FigurePage::pagePlace() const {
  if (m_page.isNull()) return {};
  const double shown = shownWidth(width());
  return {(width() - shown) / 2, double(pageMargin), shown, shown * m_page.height() / m_page.width()};
}

QRectF FigurePage::placeOf(std::size_t picture) const {
  const QRectF page = pagePlace(), &part = m_pictures[picture];
  return {page.x() + part.x() * page.width(), page.y() + part.y() * page.height(), part.width() * page.width(),
          part.height() * page.height()};
}

std::optional<std::size_t> FigurePage::pictureAt(const QPointF& position) const {
  if (!m_message.isEmpty()) return std::nullopt;
  for (std::size_t i = 0; i < m_pictures.size(); ++i)
    if (placeOf(i).contains(position)) return i;
  return std::nullopt;
}

QPointF FigurePage::inPicture(std::size_t picture, const QPointF& position) const {
  const QRectF place = placeOf(picture);
  return {std::clamp((position.x() - place.x()) / place.width(), 0.0, 1.0),
          std::clamp((position.y() - place.y()) / place.height(), 0.0, 1.0)};
}

void FigurePage::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!m_message.isEmpty() || m_page.isNull()) return paintMessage(painter);
  const QRectF place = pagePlace();
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(place, m_page);
  paintDrag(painter);
}

void FigurePage::paintMessage(QPainter& painter) const {
  painter.setPen(palette().color(QPalette::WindowText));
  const int margin = 3 * pageMargin;
  painter.drawText(rect().adjusted(margin, margin, -margin, -margin), Qt::AlignCenter | Qt::TextWordWrap, m_message);
}

void FigurePage::paintDrag(QPainter& painter) const {
  if (!m_drag) return;
  painter.setBrush(Qt::NoBrush);
  for (std::size_t i = 0; i < m_pictures.size(); ++i) {
    const QRectF place = placeOf(i), &square = m_drag->square;
    const QRectF drawn(place.x() + square.x() * place.width(), place.y() + square.y() * place.height(),
                       square.width() * place.width(), square.height() * place.height());
    // White on black is visible on every picture.
    painter.setPen(QPen(Qt::black, 3));
    painter.drawRect(drawn);
    painter.setPen(QPen(Qt::white, 1));
    painter.drawRect(drawn);
  }
}

void FigurePage::mousePressEvent(QMouseEvent* event) {
  const auto picture = pictureAt(event->position());
  if (event->button() != Qt::LeftButton || !picture) return QWidget::mousePressEvent(event);
  const QPointF start = inPicture(*picture, event->position());
  const bool moves = m_square && m_square->contains(start);
  m_drag = Drag{*picture, start, moves ? m_square : std::nullopt, moves ? *m_square : QRectF(start, QSizeF(0, 0))};
  update();
}

void FigurePage::mouseMoveEvent(QMouseEvent* event) {
  if (!m_drag) {
    const auto picture = pictureAt(event->position());
    const bool moves = picture && m_square && m_square->contains(inPicture(*picture, event->position()));
    return setCursor(moves ? Qt::SizeAllCursor : picture ? Qt::CrossCursor : Qt::ArrowCursor);
  }
  const QPointF at = inPicture(m_drag->picture, event->position());
  m_drag->square = m_drag->moved ? movedBy(*m_drag->moved, at - m_drag->start) : squareBetween(m_drag->start, at);
  update();
}

void FigurePage::mouseReleaseEvent(QMouseEvent* event) {
  if (!m_drag || event->button() != Qt::LeftButton) return QWidget::mouseReleaseEvent(event);
  const QRectF square = m_drag->square;
  m_drag.reset();
  update();
  if (square.width() < minDrawnSide || square == m_square) return;
  m_square = square;
  Q_EMIT squareDrawn(square);
}

void FigurePage::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape || !m_drag) return QWidget::keyPressEvent(event);
  m_drag.reset();
  update();
}

void FigurePage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  updateGeometry();
  reportWidth();
}

}  // namespace gonio::widgets

#include "moc_figure_page.cpp"
