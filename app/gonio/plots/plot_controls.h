// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QToolBar>

#include "app/gonio/plots/plot_data.h"

class QCheckBox;
class QComboBox;
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
  widgets::PlotSettings settings;
  plots::SectionAxis axis = plots::SectionAxis::thetaO;
  double phiD = halfPi, thetaH = 0, planeAzimuth = 0;  ///< rad
  plots::ThetaHSpacing spacing = plots::ThetaHSpacing::squareRoot;

  bool operator==(const PlotChoices&) const = default;
  /// The section that these choices are: along theta_h, theta_d is the angle of incidence.
  plots::Section section() const;
};

/// The line above the plots: which plot, angle of incidence, channel, cosine, logarithm, picking on the sphere, export.
/// Shows only what the chosen plot needs.
class PlotControls : public QToolBar {
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
  void exportRequested(const QString& suffix);

 private:
  void addKinds();
  void addSections();
  void addIncidence();
  void addValues();
  void addExport();
  QAction* addNumber(const QString& label, const QString& toolTip, double min, double max, double PlotChoices::*member,
                     widgets::NumberField*& field);
  QAction* addLabelled(const QString& label, QWidget* widget);
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
  QAction *m_axisAction, *m_spacingAction, *m_phiDAction, *m_thetaHAction, *m_planeAzimuthAction, *m_cosineAction;
};

}  // namespace gonio::app
