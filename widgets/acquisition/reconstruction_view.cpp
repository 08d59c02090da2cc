// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/acquisition/reconstruction_view.h"

#include <QPainter>
#include <algorithm>
#include <vector>

#include "core/rendering/error_maps.h"
#include "widgets/charts/plot_style.h"
#include "widgets/inputs/number_field.h"
#include "widgets/interpolation/sphere_picture.h"

namespace gonio::widgets {

namespace {
constexpr double gapEms = 0.8, captionEms = 1.3, legendEms = 2.2;

/// The place of the hint: the middle, or the top if pictures stand below it.
QRect hintPlace(const QWidget& view, const QString& hint, bool isAbovePictures) {
  const int em = view.fontMetrics().height();
  QRect room = view.rect().adjusted(em, em / 2, -em, -em / 2);
  if (isAbovePictures) room.setHeight(view.fontMetrics().boundingRect(room, Qt::TextWordWrap, hint).height());
  return room;
}
}  // namespace

ReconstructionView::ReconstructionView(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Reconstruction beside its reference"));
  setToolTip(
      tr("The measured material, its reconstruction from the samples, and the luminance error |L1 − L2| "
         "in scene radiance"));
}

QSize ReconstructionView::sizeHint() const { return QSize(26, 13) * fontMetrics().height(); }
QSize ReconstructionView::minimumSizeHint() const { return QSize(12, 7) * fontMetrics().height(); }

void ReconstructionView::setContent(const Content& content) {
  m_content = content;
  update();
}

void ReconstructionView::setHint(const QString& hint) {
  m_hint = hint;
  update();
}

std::vector<ReconstructionView::Picture> ReconstructionView::pictures() const {
  std::vector<Picture> shown;
  if (!m_content.reference.isNull()) shown.push_back({m_content.reference, m_content.referenceName});
  if (!m_content.reconstruction.isNull()) shown.push_back({m_content.reconstruction, tr("reconstruction")});
  if (!m_content.errorMap.isNull()) shown.push_back({m_content.errorMap, tr("luminance error")});
  return shown;
}

QList<QRectF> ReconstructionView::squares() const {
  const int count = int(pictures().size());
  const double em = fontMetrics().height(), gap = gapEms * em;
  // Under each picture its caption; under the error map the legend too, for which all rows have room.
  const double below = (captionEms + (m_content.errorMap.isNull() ? 0 : legendEms)) * em;
  const bool isHinted = m_content.reconstruction.isNull() && !m_hint.isEmpty();
  const double above = isHinted && count > 0 ? hintPlace(*this, m_hint, true).bottom() : 0, room = height() - above;
  int columns = 1;
  double side = 0;
  for (int tried = 1; tried <= count; ++tried) {
    const int rows = (count + tried - 1) / tried;
    const double fits = std::min((width() - gap * (tried + 1)) / tried, (room - gap) / rows - below);
    if (fits <= side) continue;
    side = fits;
    columns = tried;
  }
  QList<QRectF> result;
  const double across = (side + gap) * std::min(columns, count) - gap, left = (width() - across) / 2;
  const double up = (side + below) * ((count + columns - 1) / columns),
               top = above + std::max(gap / 2, (room - up) / 2);
  for (int i = 0; i < count; ++i)
    result << QRectF(left + (i % columns) * (side + gap), top + (i / columns) * (side + below), side, side);
  return result;
}

void ReconstructionView::drawLegend(QPainter& painter, const QRectF& square) const {
  const double em = fontMetrics().height();
  const QRectF bar(square.left(), square.bottom() + captionEms * em + 2, square.width(), 0.6 * em);
  painter.setRenderHint(QPainter::Antialiasing, false);
  for (int x = 0; x < int(bar.width()); ++x) {
    const rendering::DisplayColour colour = rendering::viridis(x / std::max(1.0, bar.width() - 1));
    painter.fillRect(QRectF(bar.left() + x, bar.top(), 1, bar.height()), QColor(colour[0], colour[1], colour[2]));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(palette().color(QPalette::Text));
  const QRectF numbers(bar.left(), bar.bottom() + 1, bar.width(), em);
  painter.drawText(numbers, Qt::AlignLeft, QStringLiteral("0"));
  painter.drawText(numbers, Qt::AlignRight, tr("≥ %1").arg(formatNumber(m_content.errorRange)));
}

void ReconstructionView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), PlotStyle::of(palette()).background);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto shown = pictures();
  const QList<QRectF> places = squares();
  const double em = fontMetrics().height();
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const QRectF& square = places[qsizetype(i)];
    paintSphere(painter, shown[i].image, square, palette());
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRectF(square.left(), square.bottom(), square.width(), captionEms * em), Qt::AlignCenter,
                     fontMetrics().elidedText(shown[i].caption, Qt::ElideMiddle, int(square.width())));
  }
  if (!m_content.errorMap.isNull()) drawLegend(painter, places.back());
  if (!m_content.reconstruction.isNull() || m_hint.isEmpty()) return;
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(hintPlace(*this, m_hint, !shown.empty()), Qt::AlignCenter | Qt::TextWordWrap, m_hint);
}

}  // namespace gonio::widgets

#include "moc_reconstruction_view.cpp"
