// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/export/export_pictures.h"

#include <QPainter>
#include <algorithm>

namespace gonio::app {

namespace {
constexpr int maxSide = 240, minSide = 120, gap = 12;
const QColor pictureGround(38, 38, 38);
}  // namespace

ExportPictures::ExportPictures(QWidget* parent) : QWidget(parent) {
  m_names[0] = tr("Material");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setMinimumSize(2 * minSide + gap, minSide + 2 * fontMetrics().height());
  setAccessibleName(tr("Material and export"));
}

QSize ExportPictures::sizeHint() const { return {2 * maxSide + gap, maxSide + 2 * fontMetrics().height()}; }

void ExportPictures::setPictures(const QImage& original, const QImage& exported) {
  m_pictures[0] = original;
  m_pictures[1] = exported;
  update();
}

void ExportPictures::setExportedName(const QString& name) {
  m_names[1] = name;
  update();
}

void ExportPictures::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const int line = fontMetrics().height() * 3 / 2;
  const int side = std::min({maxSide, (width() - gap) / 2, height() - line});
  const int left = (width() - 2 * side - gap) / 2, top = (height() - side - line) / 2;
  for (int i = 0; i < 2; ++i) {
    const QRect place(left + i * (side + gap), top, side, side);
    painter.fillRect(place, pictureGround);
    if (!m_pictures[i].isNull()) painter.drawImage(place, m_pictures[i]);
    const QRect text(place.left(), place.bottom() + 1, side, line);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(text, Qt::AlignCenter, fontMetrics().elidedText(m_names[i], Qt::ElideRight, side));
  }
}

}  // namespace gonio::app

#include "moc_export_pictures.cpp"
