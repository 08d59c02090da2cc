// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/acquisition_sample_model.h"

#include "core/coordinates/half_difference.h"
#include "widgets/acquisition/sample_chart.h"
#include "widgets/inputs/number_field.h"

namespace gonio::app {

namespace {

double angleIn(const DirectionPair& pair, int column) {
  const HalfDifference at = toHalfDifference(pair.wi, pair.wo);
  switch (column) {
    case AcquisitionSampleModel::ThetaIColumn:
      return polarAngle(pair.wi);
    case AcquisitionSampleModel::PhiIColumn:
      return azimuth(pair.wi);
    case AcquisitionSampleModel::ThetaOColumn:
      return polarAngle(pair.wo);
    case AcquisitionSampleModel::PhiOColumn:
      return azimuth(pair.wo);
    case AcquisitionSampleModel::ThetaHColumn:
      return at.thetaH;
    case AcquisitionSampleModel::ThetaDColumn:
      return at.thetaD;
    default:
      return foldPhiD(at.phiD);
  }
}

}  // namespace

void AcquisitionSampleModel::setDirections(const std::vector<DirectionPair>& directions) {
  acquisition::SamplingPlan plan;
  for (const DirectionPair& pair : directions)
    plan.samples.push_back({.index = int(plan.samples.size()) + 1, .directions = pair, .order = 0});
  setPlan(plan);
}

void AcquisitionSampleModel::setPlan(const acquisition::SamplingPlan& plan) {
  // Rows are only added while directions are chosen: the view keeps its place.
  const bool grows = plan.samples.size() >= m_samples.size() && !m_samples.empty();
  if (!grows) {
    beginResetModel();
    m_samples = plan.samples;
    m_values = {};
    endResetModel();
    return;
  }
  if (const int old = rowCount(), now = int(plan.samples.size()); now > old) {
    beginInsertRows({}, old, now - 1);
    m_samples = plan.samples;
    endInsertRows();
  }
  m_samples = plan.samples;
  Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

void AcquisitionSampleModel::setValues(const acquisition::MeasuredValues& values) {
  m_values = values;
  if (rowCount() > 0) Q_EMIT dataChanged(index(0, RedColumn), index(rowCount() - 1, BlueColumn));
}

int AcquisitionSampleModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(m_samples.size());
}
int AcquisitionSampleModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QString AcquisitionSampleModel::text(const QModelIndex& index) const {
  const acquisition::PlannedSample& sample = m_samples[std::size_t(index.row())];
  if (index.column() == IndexColumn) return QString::number(sample.index);
  if (index.column() == OrderColumn) return sample.order > 0 ? QString::number(sample.order) : QString();
  if (index.column() < OrderColumn) return QString::number(degrees(angleIn(sample.directions, index.column())), 'f', 1);
  if (std::size_t(index.row()) >= m_values.rgb.size()) return {};
  return widgets::formatNumber(m_values.rgb[std::size_t(index.row())][index.column() - RedColumn]);
}

QVariant AcquisitionSampleModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (role == Qt::DisplayRole) return text(index);
  if (role == Qt::TextAlignmentRole) return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole)
    return widgets::sampleText(index.row() + 1, m_samples[std::size_t(index.row())].directions);
  return {};
}

QVariant AcquisitionSampleModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const std::pair<QString, QString> titles[] = {
      {tr("#"), tr("Rank in the order of selection; with the SOMP methods, the first samples contribute most")},
      {tr("θi [°]"), tr("Polar angle of the light, degrees")},
      {tr("φi [°]"), tr("Azimuth of the light, degrees")},
      {tr("θo [°]"), tr("Polar angle of the viewer, degrees")},
      {tr("φo [°]"), tr("Azimuth of the viewer, degrees")},
      {tr("θh [°]"), tr("Half angle: between half vector and normal, degrees")},
      {tr("θd [°]"), tr("Difference angle: half the angle between light and viewer, degrees")},
      {tr("φd [°]"), tr("Azimuth of the light about the half vector, degrees")},
      {tr("Order"), tr("Position in a measurement order that shortens the travel of the goniometer's arms")},
      {tr("R [1/sr]"), tr("Measured BRDF value, linear red, 1/sr")},
      {tr("G [1/sr]"), tr("Measured BRDF value, linear green, 1/sr")},
      {tr("B [1/sr]"), tr("Measured BRDF value, linear blue, 1/sr")}};
  if (role == Qt::DisplayRole) return titles[section].first;
  if (role == Qt::ToolTipRole) return titles[section].second;
  if (role == Qt::TextAlignmentRole) return int(Qt::AlignRight | Qt::AlignVCenter);
  return {};
}

}  // namespace gonio::app

#include "moc_acquisition_sample_model.cpp"
