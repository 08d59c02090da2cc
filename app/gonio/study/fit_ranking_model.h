// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QAbstractTableModel>
#include <QIcon>
#include <vector>

#include "core/study/accuracy_study.h"

namespace gonio::app {

/// The fits of one material as rows. Qt::UserRole is the sort key of a column: a number that is smaller for better
/// rows, or a name.
class FitRankingModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column {
    NameColumn,
    PlotColumn,
    ErrorColumn,
    SnrColumn,
    ParametersColumn,
    SecondsColumn,
    WarningsColumn,
    ColumnCount
  };

  using QAbstractTableModel::QAbstractTableModel;

  void clear();
  /// Adds a row, or replaces the row of the same model.
  void add(const study::RankedFit& ranked);
  const study::RankedFit& ranked(int row) const { return m_rows[std::size_t(row)].ranked; }
  /// Sets the error shown in the error column.
  void setMetric(metrics::BrdfMetric metric);
  metrics::BrdfMetric metric() const { return m_metric; }
  /// The fits that the user has checked, in the order of the rows.
  std::vector<const fitting::FitResult*> plotted() const;
  /// Marks the model that is being edited; null: none.
  void setCurrent(const models::Model* model);

  /// Comma-separated text: all rows in the order of the models, with all errors.
  QString csv() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 Q_SIGNALS:
  void plottedChanged();

 private:
  struct Row {
    study::RankedFit ranked;
    QIcon thumbnail;
    bool plotted = false;
  };
  double error(const Row& row) const;
  QVariant text(const Row& row, int column) const;
  QVariant sortKey(const Row& row, int column) const;

  std::vector<Row> m_rows;
  metrics::BrdfMetric m_metric = metrics::BrdfMetric::log;
  const models::Model* m_current = nullptr;
};

}  // namespace gonio::app
