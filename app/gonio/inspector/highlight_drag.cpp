// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/inspector/highlight_drag.h"

#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "app/gonio/document/edit_steps.h"
#include "widgets/parameters/parameter_text.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {

using editing::ArtistControl;
using editing::DifferentialEdit;

double valueOf(const DifferentialEdit& edit, ArtistControl control) {
  return edit.controls.values[std::size_t(control)].x;
}

/// "Roughness 2", one line for each of both controls.
QString valuesText(const DifferentialEdit& edit) {
  QStringList lines;
  for (const ArtistControl control : {ArtistControl::roughness, ArtistControl::specularStrength}) {
    const models::ParameterSpec& spec = editing::artistControls().parameters[std::size_t(control)];
    lines << QStringLiteral("%1 %2").arg(widgets::toQString(spec.label),
                                         widgets::displayValue(spec, edit.controls.values[std::size_t(control)]));
  }
  return lines.join('\n');
}

}  // namespace

HighlightDrag::HighlightDrag(widgets::PreviewWidget& preview, Document& document)
    : QObject(&preview), m_preview(preview), m_document(document) {
  connect(&preview.input(), &widgets::PreviewInput::editStarted, this, &HighlightDrag::begin);
  connect(&preview.input(), &widgets::PreviewInput::editDragged, this, &HighlightDrag::drag);
  connect(&preview.input(), &widgets::PreviewInput::editFinished, this, &HighlightDrag::end);
}

int HighlightDrag::outwards(const QImage& picture, const QPointF& place) {
  if (picture.isNull()) return 1;
  // So few pixels that noise and the grain of flakes are smoothed away.
  constexpr int columns = 32;
  constexpr double reach = columns / 6.0, contrast = 4;
  const QImage small =
      picture.scaledToWidth(columns, Qt::SmoothTransformation).convertToFormat(QImage::Format_Grayscale8);
  const QPointF at(place.x() * columns, place.y() * small.height());
  double offset = 0;
  for (int y = 0; y < small.height(); ++y)
    for (int x = 0; x < columns; ++x) {
      const double dx = x + 0.5 - at.x(), dy = y + 0.5 - at.y(), grey = qGray(small.pixel(x, y)) / 255.0;
      offset += dx * std::pow(grey, contrast) * std::exp(-(dx * dx + dy * dy) / (2 * reach * reach));
    }
  return offset > 0 ? -1 : 1;
}

void HighlightDrag::begin(const QPointF& position) {
  const auto* edit = m_document.active<DifferentialEdit>();
  if (!edit) return;
  m_roughness = valueOf(*edit, ArtistControl::roughness);
  m_strength = valueOf(*edit, ArtistControl::specularStrength);
  m_outwards = outwards(m_preview.picture(), {position.x() / m_preview.width(), position.y() / m_preview.height()});
  m_document.beginInteraction();
}

void HighlightDrag::drag(const QPointF& pixels, const QPoint& place) {
  const auto* edit = m_document.active<DifferentialEdit>();
  if (!edit)
    return QToolTip::showText(place, tr("Fit a model in the Inspector to edit the highlight here"), &m_preview);
  const auto factor = [](double way) {
    return std::exp2((way - std::clamp(way, -deadPixels, deadPixels)) / pixelsPerDoubling);
  };
  constexpr double weakest = 0.01;  // a highlight that is off can be drawn up again
  const double up = factor(-pixels.y());
  setHighlight(m_document, m_roughness * factor(m_outwards * pixels.x()),
               up == 1 ? m_strength : std::max(m_strength, weakest) * up);
  if (const auto* changed = m_document.active<DifferentialEdit>())
    QToolTip::showText(place, valuesText(*changed), &m_preview);
}

void HighlightDrag::end() {
  m_document.endInteraction();
  QToolTip::hideText();
}

}  // namespace gonio::app

#include "moc_highlight_drag.cpp"
