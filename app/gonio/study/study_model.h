// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QAbstractTableModel>
#include <QIcon>
#include <memory>
#include <vector>

#include "core/study/accuracy_study.h"
#include "core/study/study_plot.h"

namespace gonio::app {

/// Representations as rows, with their results for one material or, as medians, for several: "-" and grey until they
/// are measured. Two sets of columns, isShown(): one material has images, errors and what concerns fits, several have
/// their number and the worst of them. Qt::UserRole is the sort key of a column: a number that is smaller for better
/// rows, or a name.
class StudyModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column {
    NameColumn,
    PlotColumn,
    MaterialsColumn,
    SnrColumn,
    WorstSnrColumn,
    WorstMaterialColumn,
    ErrorColumn,
    EvaluationColumn,
    FrameColumn,
    BytesColumn,
    EncodingColumn,
    ParametersColumn,
    WarningsColumn,
    ColumnCount
  };
  using Studied = std::shared_ptr<const study::MeasuredRepresentation>;

  using QAbstractTableModel::QAbstractTableModel;

  /// Representations are kept, for pictures of them, of at most this number of materials; of more, their numbers.
  static constexpr std::size_t maxKeptMaterials = 12;

  /// Sets the names of the materials. @param before the former place of each, whose results stay; -1: it is new.
  void setMaterials(std::vector<std::string> names, const std::vector<int>& before);
  const std::vector<std::string>& materials() const { return m_materials; }
  bool isSummary() const { return m_materials.size() > 1; }
  /// Whether a column belongs to the set of this number of materials.
  bool isShown(int column) const;

  /// Sets the rows in this order. The results of rows that remain stay.
  void plan(const std::vector<study::Representation>& representations);
  /// Keeps the results in view, in grey, until the next one is added: they are those of another material.
  void outdate();
  bool isOutdated() const { return m_outdated; }
  /// Lets measured rows count as missing; their results stay until new ones replace them.
  void requestAgain(const std::vector<study::Representation>& representations);
  /// The rows to measure for a material, in order. @param timed whether rows that were measured without times count.
  std::vector<study::Representation> missing(std::size_t material = 0, bool timed = false) const;
  /// Adds a result, or replaces the result of the same material and row; ignored if the row was not planned.
  void add(std::size_t material, const Studied& studied);

  const study::Representation& representation(int row) const { return m_rows[std::size_t(row)].representation; }
  /// The representation of a material; null until it is measured, or if it is not kept.
  Studied studied(int row, std::size_t material = 0) const;
  bool isMeasured(int row) const { return summaryOf(row) != nullptr; }
  bool isEmpty() const { return m_summaries.empty(); }
  /// The record of a measured row; of several materials their medians.
  const study::StudyRecord& record(int row) const { return summaryOf(row)->median; }
  std::vector<study::StudyRecord> records(const std::vector<int>& rows) const;
  /// The measured rows as comma-separated text, with the errors in every metric. @param title of one material.
  QString csv(const std::vector<int>& rows, const std::string& title, const study::MachineFacts& machine,
              const std::string& pictures) const;

  /// Sets the error shown in the error column.
  void setMetric(metrics::BrdfMetric metric);
  metrics::BrdfMetric metric() const { return m_metric; }
  /// Marks the row shown in the preview and the best row within the budget; -1: none.
  void setMarks(int shown, int best);
  /// Marks the model that is being edited; null: none.
  void setModelInUse(const models::Model* model);
  /// The fits that the user has ticked for the plots, in the order of the rows.
  std::vector<const fitting::FitResult*> plotted() const;
  /// Image and numbers as rich text.
  QString toolTip(int row) const;

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
    study::Representation representation;
    std::vector<Studied> studied = {};  ///< per material, as far as they are kept
    QImage picture = {};                ///< of one material
    QIcon icon = {};
    bool plotted = false;
  };
  /// Null until a material is measured.
  const study::StudySummary* summaryOf(int row) const;
  const fitting::FitResult* fitOf(int row) const;
  static void keep(Row& row, std::size_t material, const Studied& studied);
  void showPicture(Row& row) const;
  void dropResults();
  void summariseAgain();
  void refreshRows();
  QString nameOf(int row) const;
  QString text(int row, int column) const;
  QVariant sortKey(int row, int column) const;

  std::vector<std::string> m_materials{""};
  std::vector<Row> m_rows;
  std::vector<std::vector<study::StudyRecord>> m_records{{}};   ///< per material
  std::vector<std::vector<study::Representation>> m_again{{}};  ///< per material: to be measured anew
  std::vector<study::StudySummary> m_summaries;                 ///< of m_records
  bool m_outdated = false;
  metrics::BrdfMetric m_metric = metrics::BrdfMetric::log;
  int m_shown = -1, m_best = -1;
  const models::Model* m_inUse = nullptr;
};

}  // namespace gonio::app
