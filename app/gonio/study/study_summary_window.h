// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QDialog>
#include <QStringList>

#include "app/gonio/document/background_task.h"
#include "app/gonio/study/study_summary_model.h"
#include "core/study/accuracy_study.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QSortFilterProxyModel;
class QTreeView;

namespace gonio::app {

/// Accuracy versus cost for several materials: the representations of the selected families are measured in the
/// background, one material after the other, and summarised in one row per representation. If the user stops, the
/// results stay, and Measure continues from there.
class StudySummaryWindow : public QDialog {
  Q_OBJECT

 public:
  /// @param ids ids of the library: bundled materials, files, documents.
  StudySummaryWindow(BackgroundTasks& tasks, const QStringList& ids, QWidget* parent);
  ~StudySummaryWindow() override;

  StudySummaryModel& model() { return m_model; }
  QTreeView& table() const { return *m_table; }
  /// Sets the representations, instead of all representations of the selected families.
  void setChoice(const study::RepresentationChoice& choice, const study::StudyOptions& options);
  bool isRunning() const;
  void measure();
  void cancel();
  QString csv() const;
  /// The progress, and the materials that could not be read.
  QString status() const;

 protected:
  /// Escape stops the measurement first.
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void build();
  QWidget* buildFamilies();
  void planFamilies();
  void measureNext();
  void start(std::size_t material);
  void fail(std::size_t material, const QString& error);
  /// The first readable material with representations to measure.
  std::optional<std::size_t> nextMaterial() const;
  void refresh();

  BackgroundTasks& m_tasks;
  const QStringList m_ids;
  StudySummaryModel m_model;
  study::RepresentationChoice m_choice;
  study::StudyOptions m_options;
  study::MachineFacts m_machine;
  std::vector<QString> m_failures;     ///< error per material; empty: none
  QString m_key;                       ///< key of its tasks
  std::vector<QCheckBox*> m_families;  ///< of study::familiesWithoutFurtherData()
  QSortFilterProxyModel* m_sorted;
  QTreeView* m_table;
  QPushButton *m_measure, *m_copy;
  QLabel *m_empty, *m_status, *m_footer;
};

}  // namespace gonio::app
