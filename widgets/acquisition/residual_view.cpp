// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/acquisition/residual_view.h"

#include <QPainter>
#include <algorithm>

#include "core/rendering/error_maps.h"
#include "widgets/inputs/number_field.h"

namespace gonio::widgets {

namespace {
constexpr double barEms = 0.6, marginEms = 0.4;
/// The ground of images in both themes; the text on it.
constexpr QColor residualGround(46, 46, 48), residualText(222, 222, 224), residualHint(160, 160, 164);
}  // namespace

ResidualView::ResidualView(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Residual"));
  setToolTip(
      tr("Relative difference of the photograph from the reconstruction, of the luminance: (photograph − "
         "reconstruction) / reconstruction.\n"
         "Squares without colour are not used, e.g. because they are clipped."));
}

void ResidualView::setMap(const QImage& map, double range) {
  m_map = map;
  m_range = range;
  update();
}

void ResidualView::setHint(const QString& hint) {
  m_hint = hint;
  update();
}

void ResidualView::setShownRadius(double pixels) {
  m_radius = pixels;
  update();
}

int ResidualView::barWidth() const {
  const int numbers = fontMetrics().horizontalAdvance(QStringLiteral("−100 %")),
            words = fontMetrics().horizontalAdvance(tr("brighter"));
  return std::max(numbers, words) + int((barEms + 2 * marginEms) * fontMetrics().height());
}

void ResidualView::drawBar(QPainter& painter) const {
  const double em = fontMetrics().height(), margin = marginEms * em;
  const QRectF bar(width() - margin - barEms * em, 2 * margin, barEms * em, height() - 4 * margin);
  for (int y = 0; y < int(bar.height()); ++y) {
    const rendering::DisplayColour colour = rendering::signedColour(1 - 2 * y / std::max(1.0, bar.height() - 1));
    painter.fillRect(QRectF(bar.left(), bar.top() + y, bar.width(), 1), QColor(colour[0], colour[1], colour[2]));
  }
  painter.setPen(residualText);
  const QRectF texts(0, bar.top(), bar.left() - margin, bar.height());
  const QString range = formatNumber(100 * m_range);
  painter.drawText(texts, Qt::AlignRight | Qt::AlignTop, tr("+%1 %\nbrighter").arg(range));
  painter.drawText(texts, Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("0"));
  painter.drawText(texts, Qt::AlignRight | Qt::AlignBottom, tr("darker\n−%1 %").arg(range));
}

void ResidualView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), residualGround);
  if (m_map.isNull()) {
    painter.setPen(residualHint);
    const int em = fontMetrics().height();
    painter.drawText(rect().adjusted(em, em, -em, -em), Qt::AlignCenter | Qt::TextWordWrap, m_hint);
    return;
  }
  const double half = m_radius * mapExtent;
  painter.setRenderHint(QPainter::SmoothPixmapTransform, 2 * half < m_map.width());  // whole squares when enlarged
  painter.drawImage(QRectF(width() / 2.0 - half, height() / 2.0 - half, 2 * half, 2 * half), m_map);
  drawBar(painter);
}

}  // namespace gonio::widgets

#include "moc_residual_view.cpp"
