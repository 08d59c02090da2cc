// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <array>

#include "app/gonio/plots/plot_data.h"

class QCheckBox;
class QComboBox;
class QMenu;
class QSettings;
class QTabBar;
class QToolButton;

namespace gonio::widgets {
class NumberField;
class ParameterSlider;
}  // namespace gonio::widgets

namespace gonio::app {

/// The user's choices for the plots.
struct PlotChoices {
  PlotKind kind = PlotKind::polar;
  widgets::PlotSettings settings;  ///< of all plots; PlotSettings::logarithmic is ignored, see settingsOf()
  /// Whether a kind of plot has a logarithmic value axis. Lobes and slices have one, because on a linear axis only the
  /// highlight is visible.
  std::array<bool, std::size(allPlotKinds)> logarithmic{true, false, true, false, true};
  plots::SectionAxis axis = plots::SectionAxis::thetaO;
  /// phi_d is the azimuth of a slice in all coordinates.
  double phiD = halfPi, thetaH = 0, planeAzimuth = 0;  ///< rad
  plots::ThetaHSpacing spacing = plots::ThetaHSpacing::squareRoot;
  plots::SliceCoordinates coordinates = plots::SliceCoordinates::halfDifference;

  bool operator==(const PlotChoices&) const = default;
  widgets::PlotSettings settingsOf(PlotKind of) const;
  /// The section for these choices. In a section along theta_h, theta_d is the angle of incidence.
  plots::Section section() const;
};

/// The bar above the plots: kind of plot, angle of incidence, channel, cosine, logarithm, picking on the sphere,
/// export. Shows only the controls of the selected plot.
class PlotControls : public QWidget {
  Q_OBJECT

 public:
  explicit PlotControls(QWidget* parent = nullptr);

  const PlotChoices& choices() const { return m_choices; }
  /// Sets the choices; emits changed() if they differ.
  void setChoices(const PlotChoices& choices);
  void setThetaI(double thetaI);
  void setExportEnabled(bool enabled);

  void saveState(QSettings& settings) const;
  void restoreState(const QSettings& settings);

 Q_SIGNALS:
  void changed();
  void pickingToggled(bool picking);
  /// @param size of a picture, in the units of the widget; empty: as the plot is shown.
  void exportRequested(const QString& suffix, const QSize& size);

 private:
  void addKinds();
  void addSections();
  void addIncidence();
  void addValues();
  void addExport();
  void addExportSizes(QMenu* menu);
  QWidget* addNumber(const QString& label, const QString& toolTip, double min, double max, double PlotChoices::*member,
                     widgets::NumberField*& field);
  QWidget* addLabelled(const QString& label, QWidget* widget);
  template <class Change>
  void change(Change change);
  void show(const PlotChoices& choices);

  PlotChoices m_choices;
  QTabBar* m_kinds;
  QComboBox *m_axis, *m_coordinates, *m_spacing, *m_channel, *m_cosine;
  widgets::NumberField *m_phiD, *m_thetaH, *m_planeAzimuth, *m_thetaI;
  widgets::ParameterSlider* m_thetaISlider;
  QCheckBox* m_logarithmic;
  QToolButton* m_export;
  QSize m_exportSize;
  /// Rows with labels, hidden for kinds of plots that do not use them.
  QWidget *m_axisRow, *m_coordinatesRow, *m_spacingRow, *m_phiDRow, *m_thetaHRow, *m_planeAzimuthRow, *m_cosineRow;
};

}  // namespace gonio::app
