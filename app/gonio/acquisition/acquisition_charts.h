// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <span>

#include "app/gonio/acquisition/acquisition_controls.h"
#include "core/acquisition/measurable_directions.h"
#include "core/dictionary/principal_components.h"
#include "widgets/acquisition/half_difference_chart.h"

class QCheckBox;
class QLabel;
class QSlider;
namespace gonio::widgets {
class HalfDifferenceChart;
class HemisphereChart;
}  // namespace gonio::widgets

namespace gonio::app {

/// The chart's slice at the k-th phi_d of a grid: which cells can be measured, and how uncertain each cell is.
/// @param mapping the cells with training data; null before a basis is learned: then no cell is CellState::unlearned.
/// @param deviations one per cell of the mapping, or empty. O(cells of the slice).
widgets::HalfDifferenceSlice sliceAt(int k, const HalfDifferenceGrid& grid,
                                     const acquisition::MeasurableDirections& measurable,
                                     const dictionary::MappedCells* mapping, std::span<const float> deviations);

/// The samples of an acquisition on the hemisphere and in a slice of half-difference space, with the measurable cells
/// and the uncertainty of the reconstruction.
class AcquisitionCharts : public QWidget {
  Q_OBJECT

 public:
  AcquisitionCharts(const AcquisitionSession& session, const AcquisitionControls& controls);

  widgets::HemisphereChart& hemisphere() const { return *m_hemisphere; }
  widgets::HalfDifferenceChart& chart() const { return *m_chart; }
  /// Sets the sample marked in both charts; -1: none.
  void setCurrent(int sample);
  void refresh();

 Q_SIGNALS:
  void currentChanged(int sample);

 private:
  void build();
  void connectCharts();
  void showDirections();
  void showSlice();
  /// Shows the slice that contains a sample.
  void showSliceOf(int sample);

  const AcquisitionSession& m_session;
  const AcquisitionControls& m_controls;
  widgets::HemisphereChart* m_hemisphere;
  widgets::HalfDifferenceChart* m_chart;
  QSlider* m_slice;
  QLabel* m_sliceText;
  QCheckBox* m_uncertainty;
};

}  // namespace gonio::app
