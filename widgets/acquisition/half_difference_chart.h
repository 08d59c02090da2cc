// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QBrush>
#include <QImage>
#include <QString>
#include <cstdint>

#include "core/coordinates/half_difference_grid.h"
#include "widgets/acquisition/sample_chart.h"
#include "widgets/charts/plot_style.h"

namespace gonio::widgets {

/// State of a cell of the grid.
enum class CellState : std::uint8_t {
  measurable,
  belowHorizon,  ///< light or viewer is below the horizon
  grazing,       ///< beyond the maximum polar angle
  forbidden,     ///< in a forbidden region of the rig
  unlearned      ///< invalid in at least one material of the training set
};

/// The shaded states, in the order of the legend.
inline constexpr CellState shadedStates[] = {CellState::belowHorizon, CellState::grazing, CellState::forbidden,
                                             CellState::unlearned};

/// "beyond the max. polar angle"
QString stateName(CellState state);
/// Shading of cells, distinguishable by the hatching.
QBrush stateBrush(CellState state, const PlotStyle& style);

/// The cells of a grid at one phi_d.
struct HalfDifferenceSlice {
  double phiD = halfPi;  ///< rad, [0, pi)
  int thetaHCount = 0, thetaDCount = 0;
  std::vector<CellState> states;  ///< theta_d runs fastest
  std::vector<float> deviations;  ///< standard deviation of the mapped value, NaN if there is none; or empty
};

/// Samples over the two angles of half-difference space, theta_h upward with the spacing of MERL tables, for one phi_d.
/// Cells that cannot be measured are shaded; the uncertainty is shown in false colour. Samples near that phi_d are
/// filled, others hollow.
class HalfDifferenceChart : public SampleChart {
  Q_OBJECT

 public:
  /// Maximum distance in phi_d of samples that are drawn as part of the slice, rad.
  static constexpr double sliceWidth = radians(15);

  explicit HalfDifferenceChart(QWidget* parent = nullptr);

  void setSlice(HalfDifferenceSlice slice);
  const HalfDifferenceSlice& slice() const { return m_slice; }
  /// The standard deviation at the last colour of the map; the first colour is 0.
  void setRange(double range);
  double range() const { return m_range; }

  /// Position of angles (rad), in widget pixels.
  QPointF placeOf(double thetaH, double thetaD) const;
  QList<QPointF> places(int sample) const override;
  /// Whether a sample is drawn as part of the slice.
  bool isInSlice(int sample) const;
  /// The centre of a cell, and the cell at a position (-1 outside).
  QPointF cellCentre(int thetaH, int thetaD) const;
  int cellAt(const QPointF& place) const;

  QSize sizeHint() const override;

 protected:
  QString toolTipOf(int sample) const override;
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  QRectF plot() const;
  bool hasDeviations() const { return !m_slice.deviations.empty(); }
  std::vector<CellState> shownStates() const;
  void paintImage();
  void drawShading(QPainter& painter) const;
  void drawAxes(QPainter& painter) const;
  void drawSamples(QPainter& painter) const;
  void drawColourBar(QPainter& painter) const;
  void drawLegend(QPainter& painter) const;

  HalfDifferenceSlice m_slice;
  double m_range = 1;
  QImage m_image;  ///< one pixel per cell, theta_d to the right, theta_h upward
};

}  // namespace gonio::widgets
