// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/parameters/colour_swatch.h"

#include <QPainter>
#include <algorithm>

#include "core/rendering/tone_map.h"
#include "widgets/parameters/colour_picker.h"

namespace gonio::widgets {

namespace {

/// The display colour of a linear one, and by what it was divided to fit.
QColor displayColour(const Rgb& linear, double& scale) {
  scale = std::max(1.0, maxChannel(linear));
  const auto byte = [&](double value) { return float(toSrgb(std::clamp(value / scale, 0.0, 1.0))); };
  return QColor::fromRgbF(byte(linear.x), byte(linear.y), byte(linear.z));
}

}  // namespace

ColourSwatch::ColourSwatch(QWidget* parent) : QAbstractButton(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  connect(this, &QAbstractButton::clicked, this, &ColourSwatch::openDialog);
}

void ColourSwatch::setColour(const Rgb& linear) {
  m_colour = linear;
  update();
}

QSize ColourSwatch::sizeHint() const {
  const int side = fontMetrics().height() + 4;
  return {side, side};
}

void ColourSwatch::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF area = QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5);
  double scale = 1;
  painter.setBrush(isEnabled() ? displayColour(m_colour, scale) : palette().color(QPalette::Window));
  const QColor edge = palette().color(hasFocus() ? QPalette::Highlight : QPalette::Mid);
  painter.setPen(QPen(edge, hasFocus() ? 2 : 1));
  painter.drawRoundedRect(area, 3, 3);
  if (scale > 1) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Text));
    const QPointF corner = area.topRight();
    painter.drawPolygon(QPolygonF{corner, corner - QPointF(6, 0), corner + QPointF(0, 6)});
  }
}

void ColourSwatch::openDialog() {
  const Rgb before = m_colour;
  double scale = 1;
  // On the heap and without an event loop of its own: the row of the swatch may go while the dialog is open.
  auto* dialog = new ColourPicker(displayColour(before, scale), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(accessibleName());
  connect(dialog, &ColourPicker::colourChanged, this, [this, scale](const QColor& chosen) {
    const Rgb linear(fromSrgb(chosen.redF()), fromSrgb(chosen.greenF()), fromSrgb(chosen.blueF()));
    setColour(linear * scale);
    Q_EMIT colourEdited(m_colour);
  });
  connect(dialog, &QDialog::finished, this, [this, before](int result) {
    if (result != QDialog::Accepted) {
      setColour(before);
      Q_EMIT colourEdited(before);
    }
    Q_EMIT editingFinished();
  });
  // Below the swatch, so that the picture, which shows the result, is in view.
  dialog->adjustSize();
  dialog->move(mapToGlobal(QPoint(width() - dialog->width(), height())));
  Q_EMIT editingStarted();
  dialog->open();
}

}  // namespace gonio::widgets

#include "moc_colour_swatch.cpp"
