// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QPalette>
#include <QPen>

namespace gonio::widgets {

/// Where a curve comes from: it decides its colour and line style in every chart. Numbers from `otherFit` on are the
/// fits beside the one in use.
enum class SeriesRole { measured, fit, edited, otherFit };
constexpr SeriesRole otherFit(int number) { return SeriesRole(int(SeriesRole::otherFit) + number); }

/// Colours and lines of a chart: the application's palette on the screen, dark on white in exported files.
struct PlotStyle {
  QColor background, text, grid, accent;
  bool dark = false;

  static PlotStyle of(const QPalette& palette);
  static PlotStyle paper();

  QColor colour(SeriesRole role) const;
  /// Measured solid, fit dashed, edited dash-dotted, others by more patterns: curves are distinguishable without their
  /// colours, which come again after six other fits.
  QPen pen(SeriesRole role) const;
  QPen gridPen() const { return QPen(grid, 1); }
  /// Of the line that marks the angle of incidence.
  QPen accentPen() const { return QPen(accent, 1.5); }
};

}  // namespace gonio::widgets
