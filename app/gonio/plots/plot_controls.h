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

/// What the user chose to see in the plots.
struct PlotChoices {
  PlotKind kind = PlotKind::polar;
  widgets::PlotSettings settings;  ///< of all plots but the logarithm, see settingsOf()
  /// Whether a kind has a logarithmic axis of values. Lobes have: on a linear one a highlight is all that is seen.
  std::array<bool, std::size(allPlotKinds)> logarithmic{true, false, false, false, true};
  plots::SectionAxis axis = plots::SectionAxis::thetaO;
  double phiD = halfPi, thetaH = 0, planeAzimuth = 0;  ///< rad
  plots::ThetaHSpacing spacing = plots::ThetaHSpacing::squareRoot;

  bool operator==(const PlotChoices&) const = default;
  widgets::PlotSettings settingsOf(PlotKind of) const;
  /// The section that these choices are: along theta_h, theta_d is the angle of incidence.
  plots::Section section() const;
};

/// The line above the plots: which plot, angle of incidence, channel, cosine, logarithm, picking on the sphere, export.
/// Shows only what the chosen plot needs.
class PlotControls : public QWidget {
  Q_OBJECT

 public:
  explicit PlotControls(QWidget* parent = nullptr);

  const PlotChoices& choices() const { return m_choices; }
  /// Shows choices; emits changed() when they are others.
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
  QComboBox *m_axis, *m_spacing, *m_channel, *m_cosine;
  widgets::NumberField *m_phiD, *m_thetaH, *m_planeAzimuth, *m_thetaI;
  widgets::ParameterSlider* m_thetaISlider;
  QCheckBox* m_logarithmic;
  QToolButton* m_export;
  QSize m_exportSize;
  /// With their labels; hidden where a kind of plot has no use for them.
  QWidget *m_axisRow, *m_spacingRow, *m_phiDRow, *m_thetaHRow, *m_planeAzimuthRow, *m_cosineRow;
};

}  // namespace gonio::app
