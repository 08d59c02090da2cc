// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/plots/cartesian_plot.h"

#include "widgets/inputs/number_field.h"
#include "widgets/plots/plot_text.h"

namespace gonio::widgets {

using plots::SectionAxis;

CartesianPlot::CartesianPlot(QWidget* parent) : CurveChart(tr("Cartesian"), parent) {
  setAccessibleDescription(tr("BRDF values vs. one angle; the other angles are fixed."));
}

void CartesianPlot::setSection(const plots::Section& section, PlotSeriesList<plots::Curve> series) {
  // Another axis is another view.
  const bool otherAxis = section.axis != m_section.axis;
  m_section = section;
  setSeries(std::move(series));
  if (otherAxis) resetView();
}

ChartAxes CartesianPlot::axes() const {
  const QString value = valueTitle(settings());
  const std::string comment = valueForCsv(settings());
  const auto fixed = [](const QString& name, double angle) {
    return QStringLiteral("%1 = %2").arg(name, degreesText(angle));
  };
  switch (m_section.axis) {
    case SectionAxis::thetaH:
      return {tr("θh [°], %1, %2").arg(fixed(tr("θd"), m_section.thetaD), fixed(tr("φd"), m_section.phiD)),
              value,
              0,
              90,
              "theta_h",
              "1/sr",
              tr("1/sr"),
              comment};
    case SectionAxis::thetaD:
      return {tr("θd [°], %1, %2").arg(fixed(tr("θh"), m_section.thetaH), fixed(tr("φd"), m_section.phiD)),
              value,
              0,
              90,
              "theta_d",
              "1/sr",
              tr("1/sr"),
              comment};
    case SectionAxis::thetaO:
      break;
  }
  const QString plane = m_section.planeAzimuth == 0
                            ? tr("in the plane of incidence")
                            : tr("%1 from the plane of incidence").arg(degreesText(m_section.planeAzimuth));
  return {tr("θo [°], %1, %2").arg(plane, fixed(tr("θi"), m_section.thetaI)),
          value,
          -90,
          90,
          "theta_o",
          "1/sr",
          tr("1/sr"),
          comment};
}

std::optional<double> CartesianPlot::incidence() const {
  switch (m_section.axis) {
    case SectionAxis::thetaH:
      return std::nullopt;
    case SectionAxis::thetaD:
      return degrees(settings().thetaI);
    case SectionAxis::thetaO:
      break;
  }
  return degrees(settings().thetaI);  // the mirror direction
}

std::vector<std::string> CartesianPlot::fixedForCsv() const {
  switch (m_section.axis) {
    case SectionAxis::thetaH:
      return {angleForCsv("theta_d", m_section.thetaD), angleForCsv("phi_d", m_section.phiD)};
    case SectionAxis::thetaD:
      return {angleForCsv("theta_h", m_section.thetaH), angleForCsv("phi_d", m_section.phiD)};
    case SectionAxis::thetaO:
      break;
  }
  return {angleForCsv("theta_i", m_section.thetaI),
          angleForCsv("azimuth of the viewer's plane from the plane of incidence", m_section.planeAzimuth),
          "theta_o > 0 lies on the side of the mirror direction"};
}

}  // namespace gonio::widgets

#include "moc_cartesian_plot.cpp"
