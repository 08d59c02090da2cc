// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QPainter>

#include "core/plots/lobe_surface.h"
#include "core/plots/value_scale.h"
#include "widgets/charts/plot_style.h"
#include "widgets/plots/plot_series.h"

namespace gonio::widgets {

/// From where a lobe is looked at: orthographic, the normal upwards.
struct LobeView {
  double yaw = radians(-65);   ///< rad; -90 degrees looks at the plane of incidence, the mirror side to the right
  double pitch = radians(22);  ///< rad above the surface, (-pi/2, pi/2)
  double zoom = 1;

  Direction toEye() const;
  Direction right() const;
  Direction up() const;
};

/// A lobe in a part of a picture: its place on the page.
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

/// Surface, normal, directions of light and mirror, name and the value of the ground's circle. The surface is made of
/// shaded quadrilaterals, far ones first: it can be exported as SVG.
void drawLobe(QPainter& painter, const QRectF& cell, const LobePlace& place, const LobePicture& picture,
              const PlotStyle& style);

/// A point of the surface: its direction, as far out as its value.
Direction lobePoint(const LobePicture& picture, std::size_t index);

}  // namespace gonio::widgets
