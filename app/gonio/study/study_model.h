// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QAbstractTableModel>
#include <QIcon>
#include <memory>
#include <optional>
#include <vector>

#include "core/study/accuracy_study.h"
#include "core/study/study_plot.h"

namespace gonio::app {

/// The representations of one material as rows: "-" and grey until they are measured. Qt::UserRole is the sort key of a
/// column: a number that is smaller for better rows, or a name.
class StudyModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column {
    NameColumn,
    SnrColumn,
    ErrorColumn,
    EvaluationColumn,
    FrameColumn,
    BytesColumn,
    EncodingColumn,
    ColumnCount
  };
  using Studied = std::shared_ptr<const study::MeasuredRepresentation>;

  using QAbstractTableModel::QAbstractTableModel;

  /// Sets the rows, not measured yet, in this order.
  void plan(const std::vector<study::Representation>& representations);
  /// Sets the rows in this order. The results of rows that were planned before stay.
  void replan(const std::vector<study::Representation>& representations);
  /// Fills the row of the same representation; ignored if it was not planned.
  void add(const Studied& studied);
  /// Null until the row is measured.
  const Studied& studied(int row) const { return m_rows[std::size_t(row)].studied; }
  const study::Representation& representation(int row) const { return m_rows[std::size_t(row)].representation; }
  std::vector<study::Representation> missing() const;
  /// Records of the measured rows, and their row numbers.
  std::vector<study::StudyRecord> records() const;
  std::vector<int> measuredRows() const;
  /// Sets the error shown in the error column.
  void setMetric(metrics::BrdfMetric metric);
  /// Marks the row shown in the preview and the best row within the budget; -1: none.
  void setMarks(int shown, int best);
  bool hasShown() const { return m_shown >= 0; }
  /// Picture and numbers as rich text; empty until the row is measured.
  QString toolTip(int row) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Row {
    study::Representation representation;
    Studied studied;
    QImage picture;
    QIcon icon;
  };
  QString nameOf(int row) const;
  QString text(const study::StudyRecord& record, int column) const;
  QVariant sortKey(const Row& row, int column) const;

  std::vector<Row> m_rows;
  metrics::BrdfMetric m_metric = metrics::BrdfMetric::log;
  int m_shown = -1, m_best = -1;
};

}  // namespace gonio::app
