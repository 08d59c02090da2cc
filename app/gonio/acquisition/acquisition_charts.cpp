// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/acquisition_charts.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <algorithm>
#include <cmath>
#include <limits>

#include "widgets/acquisition/hemisphere_chart.h"

namespace gonio::app {

namespace {

/// The place of a cell in the mapping; nothing where it does not count.
std::optional<std::size_t> placeIn(const dictionary::MappedCells& mapping, std::size_t cell) {
  const auto found = std::ranges::lower_bound(mapping.cells, cell);
  if (found == mapping.cells.end() || *found != cell) return std::nullopt;
  return std::size_t(found - mapping.cells.begin());
}

widgets::CellState stateOf(const HalfDifferenceGrid& grid, std::size_t cell,
                           const acquisition::MeasurableDirections& measurable, bool learned) {
  using widgets::CellState;
  if (!grid.nodeAboveHorizon(cell)) return CellState::belowHorizon;
  if (!grid.nodeWithin(cell, measurable.maxPolarAngle)) return CellState::grazing;
  if (!measurable.allows(grid.directions(cell))) return CellState::forbidden;
  return learned ? CellState::measurable : CellState::unlearned;
}

}  // namespace

widgets::HalfDifferenceSlice sliceAt(int k, const HalfDifferenceGrid& grid,
                                     const acquisition::MeasurableDirections& measurable,
                                     const dictionary::MappedCells* mapping, std::span<const float> deviations) {
  widgets::HalfDifferenceSlice slice{.phiD = k * grid.phiDPeriod() / grid.phiDCount,
                                     .thetaHCount = grid.thetaHCount,
                                     .thetaDCount = grid.thetaDCount,
                                     .states = {},
                                     .deviations = {}};
  for (int i = 0; i < grid.thetaHCount; ++i)
    for (int j = 0; j < grid.thetaDCount; ++j) {
      const std::size_t cell = grid.index(i, j, k);
      const auto place = mapping ? placeIn(*mapping, cell) : std::nullopt;
      slice.states.push_back(stateOf(grid, cell, measurable, place || !mapping));
      if (!deviations.empty())
        slice.deviations.push_back(place ? deviations[*place] : std::numeric_limits<float>::quiet_NaN());
    }
  return slice;
}

AcquisitionCharts::AcquisitionCharts(const AcquisitionSession& session, const AcquisitionControls& controls)
    : m_session(session),
      m_controls(controls),
      m_hemisphere(new widgets::HemisphereChart),
      m_chart(new widgets::HalfDifferenceChart),
      m_slice(new QSlider(Qt::Horizontal)),
      m_sliceText(new QLabel),
      m_uncertainty(new QCheckBox(tr("Uncertaint&y"))) {
  build();
  connectCharts();
  connect(&m_session, &AcquisitionSession::directionsChanged, this, &AcquisitionCharts::showDirections);
  connect(&m_session, &AcquisitionSession::planChanged, this, [this] {
    showDirections();
    showSlice();
  });
  connect(&m_session.referenceReader(), &ReferenceReader::changed, this, &AcquisitionCharts::showSlice);
  connect(&m_session, &AcquisitionSession::resultChanged, this, &AcquisitionCharts::showSlice);
  connect(&m_controls, &AcquisitionControls::planSettingsEdited, this, &AcquisitionCharts::showSlice);
  showSlice();
}

void AcquisitionCharts::build() {
  m_slice->setAccessibleName(tr("φd of the slice"));
  m_slice->setToolTip(
      tr("Azimuth φd of the slice of half-difference space that the chart shows; click a sample to go to its slice"));
  m_sliceText->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("180°")) + 2);
  m_sliceText->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  m_uncertainty->setChecked(true);
  m_uncertainty->setToolTip(
      tr("Shows the uncertainty of the reconstruction in false colour: the standard deviation of the mapped value in "
         "each cell, given the samples.\n"
         "Mapped value: ln((ρ w + 0.001) / (m + 0.001)), w = max(cos θi cos θo, 0.001), m the median of ρ w in the "
         "training set.\n"
         "0.1 is about 10 % of ρ, except in dark cells."));
  m_slice->setRange(0, HalfDifferenceGrid().phiDCount - 1);
  m_slice->setValue(HalfDifferenceGrid().phiDCount / 2);
  auto* label = new QLabel(tr("Slice φd"));
  label->setBuddy(m_slice);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(m_slice, 1);
  row->addWidget(m_sliceText);
  row->addWidget(m_uncertainty);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_hemisphere, 5);
  auto* right = new QVBoxLayout;
  right->addWidget(m_chart, 1);
  right->addLayout(row);
  layout->addLayout(right, 6);
}

void AcquisitionCharts::connectCharts() {
  for (widgets::SampleChart* chart : std::initializer_list<widgets::SampleChart*>{m_hemisphere, m_chart}) {
    connect(chart, &widgets::SampleChart::currentChanged, this, &AcquisitionCharts::currentChanged);
    connect(chart, &widgets::SampleChart::chosen, this, &AcquisitionCharts::showSliceOf);
  }
  connect(m_slice, &QSlider::valueChanged, this, &AcquisitionCharts::showSlice);
  connect(m_uncertainty, &QCheckBox::toggled, this, &AcquisitionCharts::showSlice);
}

void AcquisitionCharts::showSliceOf(int sample) {
  const DirectionPair& pair = m_hemisphere->samples()[std::size_t(sample)];
  const double period = pi, phiD = foldPhiD(toHalfDifference(pair.wi, pair.wo).phiD);
  const int count = m_slice->maximum() + 1;
  m_slice->setValue(int(std::lround(phiD / period * count)) % count);
}

void AcquisitionCharts::setCurrent(int sample) {
  m_hemisphere->setCurrent(sample);
  m_chart->setCurrent(sample);
}

void AcquisitionCharts::showDirections() {
  const std::vector<DirectionPair> directions = m_session.planner().directions();
  m_hemisphere->setSamples(directions);
  m_chart->setSamples(directions);
}

void AcquisitionCharts::showSlice() {
  const auto& basis = m_session.planner().basis();
  const HalfDifferenceGrid grid = basis ? basis->mapping.grid : HalfDifferenceGrid();
  m_slice->setMaximum(grid.phiDCount - 1);
  const AcquisitionResultPtr& result = m_session.result();
  const bool known = result && basis && !result->reconstruction->standardDeviation.empty();
  m_uncertainty->setEnabled(known);
  std::span<const float> deviations;
  if (known && m_uncertainty->isChecked()) deviations = result->reconstruction->standardDeviation;
  const acquisition::MeasurableDirections measurable = m_controls.planSettings().measurable;
  m_hemisphere->setMaxPolarAngle(measurable.maxPolarAngle);
  m_chart->setSlice(sliceAt(m_slice->value(), grid, measurable, basis ? &basis->mapping : nullptr, deviations));
  if (known) m_chart->setRange(result->deviationRange);
  m_sliceText->setText(tr("%1°").arg(degrees(m_chart->slice().phiD), 0, 'f', 0));
}

void AcquisitionCharts::refresh() {
  const QString hint = m_session.isBusy() ? QString() : tr("Press Start to choose directions.");
  m_hemisphere->setHint(hint);
  m_chart->setHint(hint);
}

}  // namespace gonio::app

#include "moc_acquisition_charts.cpp"
