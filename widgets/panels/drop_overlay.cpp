// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/drop_overlay.h"

#include <QPainter>

#include "widgets/inputs/text_sizes.h"

namespace gonio::widgets {

DropOverlay::DropOverlay(QWidget* target) : QWidget(target) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void DropOverlay::announce(const QString& text) {
  m_text = text;
  setGeometry(parentWidget()->rect());
  raise();
  show();
  update();
}

void DropOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor veil = palette().color(QPalette::Window);
  veil.setAlphaF(0.6f);
  painter.fillRect(rect(), veil);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 3));
  painter.drawRoundedRect(QRectF(rect()).adjusted(8, 8, -8, -8), 8, 8);
  painter.setFont(sized(font(), TextSize::large));
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(rect().adjusted(40, 40, -40, -40), Qt::AlignCenter | Qt::TextWordWrap, m_text);
}

}  // namespace gonio::widgets

#include "moc_drop_overlay.cpp"
