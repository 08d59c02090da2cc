// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <vector>

#include "core/study/study_record.h"

namespace gonio::app {

/// Representations as rows, each with its medians over several materials and the material with the largest error: "-"
/// and grey until a material is measured. Qt::UserRole is the sort key of a column: a number that is smaller for better
/// rows, or a name.
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
  /// Sets the rows. Results of other representations are dropped.
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
  /// Null until a material is measured with the row's representation.
  const study::StudySummary* summaryOf(int row) const;
  QString text(const study::StudySummary& summary, int column) const;
  QVariant sortKey(int row, int column) const;

  const std::vector<std::string> m_materials;
  std::vector<study::Representation> m_rows;
  std::vector<std::vector<study::StudyRecord>> m_records;  ///< per material
  std::vector<study::StudySummary> m_summaries;            ///< of m_records
};

}  // namespace gonio::app
