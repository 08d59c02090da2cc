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

/// The control multiplied by a factor, within its slider, or up to where it was. A highlight that is off can be drawn
/// up again.
void multiply(models::ParameterValues& controls, ArtistControl control, double factor) {
  if (factor == 1) return;
  constexpr double weakest = 0.01;
  const models::ParameterSpec& spec = editing::artistControls().parameters[std::size_t(control)];
  Rgb& value = controls.values[std::size_t(control)];
  value = Rgb(std::clamp(std::max(value.x, weakest) * factor, std::min(spec.softMin, value.x),
                         std::max(spec.softMax, value.x)));
}

/// "Roughness 2", a line for each of both controls that the model has.
QString valuesText(const DifferentialEdit& edit) {
  QStringList lines;
  for (const ArtistControl control : {ArtistControl::roughness, ArtistControl::specularStrength}) {
    if (!editing::actsOn(control, edit.model->spec())) continue;
    const models::ParameterSpec& spec = editing::artistControls().parameters[std::size_t(control)];
    lines << QStringLiteral("%1 %2").arg(widgets::toQString(spec.label),
                                         widgets::displayValue(spec, edit.controls.values[std::size_t(control)]));
  }
  return lines.isEmpty() ? HighlightDrag::tr("This model has no highlight") : lines.join('\n');
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
  m_controls = edit->controls;
  m_outwards = outwards(m_preview.picture(), {position.x() / m_preview.width(), position.y() / m_preview.height()});
  m_document.beginInteraction();
}

void HighlightDrag::drag(const QPointF& pixels, const QPoint& place) {
  const auto* edit = m_document.active<DifferentialEdit>();
  if (!edit)
    return QToolTip::showText(place, tr("Fit a model in the Inspector to edit the highlight here"), &m_preview);
  const auto factor = [edit](ArtistControl control, double way) {
    return editing::actsOn(control, edit->model->spec())
               ? std::exp2((way - std::clamp(way, -deadPixels, deadPixels)) / pixelsPerDoubling)
               : 1;
  };
  models::ParameterValues controls = m_controls;
  multiply(controls, ArtistControl::roughness, factor(ArtistControl::roughness, m_outwards * pixels.x()));
  multiply(controls, ArtistControl::specularStrength, factor(ArtistControl::specularStrength, -pixels.y()));
  setControls(m_document, controls, tr("Drag the highlight"));
  QToolTip::showText(place, valuesText(*m_document.active<DifferentialEdit>()), &m_preview);
}

void HighlightDrag::end() {
  m_document.endInteraction();
  QToolTip::hideText();
}

}  // namespace gonio::app

#include "moc_highlight_drag.cpp"
