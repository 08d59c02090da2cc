// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QAbstractTableModel>
#include <QWidget>
#include <vector>

#include "app/gonio/acquisition/acquisition_controls.h"
#include "core/acquisition/measured_values.h"

class QPushButton;
class QTableView;

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

class AcquisitionFiles;

/// The samples of an acquisition as a table, with import and export as files and text.
class SamplesPage : public QWidget {
  Q_OBJECT

 public:
  SamplesPage(const AcquisitionSession& session, const AcquisitionControls& controls, AcquisitionFiles& files);

  QTableView& table() const { return *m_table; }
  /// Selects the row of a sample; -1: none.
  void setCurrent(int sample);
  void refresh();

 Q_SIGNALS:
  void currentChanged(int sample);

 private:
  QPushButton* button(const QString& text, const QString& toolTip, std::function<void()> clicked);
  void buildTable();
  void showDirections();

  const AcquisitionSession& m_session;
  const AcquisitionControls& m_controls;
  AcquisitionSampleModel m_model;
  QTableView* m_table;
  QPushButton* m_openPlan;
  std::vector<QPushButton*> m_needPlan;  ///< enabled once there is a plan
};

}  // namespace gonio::app
