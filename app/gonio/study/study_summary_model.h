// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <vector>

#include "core/study/machine.h"
#include "core/study/study_summary.h"

namespace gonio::app {

/// Representations as rows, each with its medians over several materials and the material that it reproduces worst: "-"
/// and grey until one of them is measured. Qt::UserRole holds what a column is sorted by: a number that is smaller for
/// better rows, or a name.
class StudySummaryModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column {
    NameColumn,
    MaterialsColumn,
    MedianSnrColumn,
    WorstSnrColumn,
    WorstMaterialColumn,
    BytesColumn,
    EvaluationColumn,
    FrameColumn,
    EncodingColumn,
    ColumnCount
  };

  explicit StudySummaryModel(std::vector<std::string> materials, QObject* parent = nullptr)
      : QAbstractTableModel(parent), m_materials(std::move(materials)), m_records(m_materials.size()) {}

  const std::vector<std::string>& materials() const { return m_materials; }
  /// The rows. What was measured before of other representations is forgotten.
  void plan(const std::vector<study::Representation>& representations);
  void add(std::size_t material, const study::StudyRecord& record);
  std::vector<study::Representation> missing(std::size_t material) const;
  bool isEmpty() const { return m_summaries.empty(); }
  QString csv(const study::MachineFacts& machine, const std::string& pictures) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  /// Null while no material was measured with it.
  const study::StudySummary* summaryOf(int row) const;
  QString text(const study::StudySummary& summary, int column) const;
  QVariant sortKey(int row, int column) const;

  const std::vector<std::string> m_materials;
  std::vector<study::Representation> m_rows;
  std::vector<std::vector<study::StudyRecord>> m_records;  ///< of each material
  std::vector<study::StudySummary> m_summaries;            ///< of the records
};

}  // namespace gonio::app
