// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QPainter>

#include "core/plots/plotted_values.h"
#include "core/plots/value_scale.h"
#include "widgets/charts/plot_style.h"
#include "widgets/plots/plot_series.h"

namespace gonio::widgets {

/// The view of a lobe: an orthographic projection with the normal upwards.
struct LobeView {
  double yaw = radians(-65);   ///< azimuth of the eye, rad; at -90 degrees it looks across the plane of incidence, with
                               ///< the mirror direction on the right
  double pitch = radians(22);  ///< rad above the surface, (-pi/2, pi/2)
  double zoom = 1;

  Direction toEye() const;
  Direction right() const;
  Direction up() const;
};

/// Position and size of a lobe in a picture.
struct LobePlace {
  LobeView view;
  QPointF centre;
  double radius = 1;  ///< of the unit hemisphere, pixels

  static LobePlace filling(const QRectF& cell, double fontHeight, const LobeView& view);
  QPointF at(const Direction& point) const;
};

struct LobePicture {
  const PlotSeries<plots::LobeSurface>& series;
  PlotSettings settings;
  plots::ValueScale scale;
};

/// Draws the surface, the normal, the light and mirror directions, the name of the series, and a circle in the plane of
/// the material with the value that its radius stands for. The surface consists of shaded quadrilaterals, drawn from
/// back to front, so that it can be exported as SVG.
void drawLobe(QPainter& painter, const QRectF& cell, const LobePlace& place, const LobePicture& picture,
              const PlotStyle& style);

/// A point of the surface: its direction times its value.
Direction lobePoint(const LobePicture& picture, std::size_t index);

}  // namespace gonio::widgets
