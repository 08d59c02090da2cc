// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "core/acquisition/measured_values.h"

namespace gonio::app {

/// The samples of a plan as rows: angles in degrees, position in a measurement order with short movements of the arms,
/// and measured values.
class AcquisitionSampleModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column {
    IndexColumn,
    ThetaIColumn,
    PhiIColumn,
    ThetaOColumn,
    PhiOColumn,
    ThetaHColumn,
    ThetaDColumn,
    PhiDColumn,
    OrderColumn,
    RedColumn,
    GreenColumn,
    BlueColumn,
    ColumnCount
  };

  using QAbstractTableModel::QAbstractTableModel;

  /// Sets the directions selected so far, without a measurement order.
  void setDirections(const std::vector<DirectionPair>& directions);
  void setPlan(const acquisition::SamplingPlan& plan);
  /// @param values empty, or one per sample.
  void setValues(const acquisition::MeasuredValues& values);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QString text(const QModelIndex& index) const;

  std::vector<acquisition::PlannedSample> m_samples;
  acquisition::MeasuredValues m_values;
};

}  // namespace gonio::app
