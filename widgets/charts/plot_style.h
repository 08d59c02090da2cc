// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QPalette>
#include <QPen>

namespace gonio::widgets {

/// The source of a curve, which determines its colour and line style in all charts. Values from `otherFit` on are fits
/// other than the current one.
enum class SeriesRole { measured, fit, edited, otherFit };
constexpr SeriesRole otherFit(int number) { return SeriesRole(int(SeriesRole::otherFit) + number); }

/// Colours and lines of a chart: the application's palette on the screen, dark on white in exported files.
struct PlotStyle {
  QColor background, text, grid, accent;
  bool dark = false;

  static PlotStyle of(const QPalette& palette);
  static PlotStyle paper();

  QColor colour(SeriesRole role) const;
  /// Measured is solid, fit dashed, edited dash-dotted, others have further patterns, so that curves are
  /// distinguishable without colour. Colours repeat after six other fits.
  QPen pen(SeriesRole role) const;
  /// Line of a colour channel: 0 red, 1 green (dashed), 2 blue (dotted).
  QPen channelPen(int channel) const;
  QPen gridPen() const { return QPen(grid, 1); }
  /// Pen of the line that marks the angle of incidence.
  QPen accentPen() const { return QPen(accent, 1.5); }
};

}  // namespace gonio::widgets
