// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/study/study_budget_bar.h"
#include "app/gonio/study/study_run.h"
#include "widgets/preview/gl/preview_subject.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace gonio::app {

class StudyView;
struct SheetSource;

/// Accuracy versus cost: the representations of the selected families for the open material, measured in the background
/// and shown as a table and as points over a cost. A click on either shows the representation in the preview; a second
/// click or Escape shows the material again. It does not change the document.
class StudyPanel : public QWidget {
  Q_OBJECT

 public:
  StudyPanel(const Document& document, BackgroundTasks& tasks, QWidget* parent = nullptr);

  StudyModel& model() { return m_model; }
  StudyRun& run() const { return *m_run; }
  StudyView& view() const { return *m_view; }
  StudyBudgetBar& budgetBar() const { return *m_budget; }
  /// The representation to show in the preview, and its name; nullopt: the material.
  const std::optional<widgets::PreviewSubject>& subject() const { return m_subject; }
  QString shownName() const;

 public Q_SLOTS:
  void measure() { m_run->measure(); }
  /// Shows a row in the preview; the same row again, or -1, shows the material.
  void show(int row);
  /// The measured representations as images side by side. @return false if none is measured.
  bool openSheet();

 Q_SIGNALS:
  void subjectChanged();
  /// The user wants to use this representation.
  void useRequested(const gonio::study::Representation& representation);
  void contactSheetRequested(const gonio::app::SheetSource& source);
  void exported(const QString& path);
  void failed(const QString& title, const QString& text);

 private:
  QWidget* buildChoice();
  void buildFamilies();
  void chooseFamilies();
  void connectParts();
  void adopt(int row, const widgets::PreviewSubject& subject);
  void useBest();
  void exportSvg();
  study::StudyAxes axes() const;
  void refreshPlot();
  void refresh();
  void refreshBudget();

  const Document& m_document;
  BackgroundTasks& m_tasks;
  StudyModel m_model;
  StudyRun* m_run;
  std::optional<widgets::PreviewSubject> m_subject;
  int m_wanted = -1, m_shown = -1, m_best = -1;  ///< rows; m_wanted will be shown when it is ready
  QPushButton *m_measure, *m_families, *m_back, *m_sheet, *m_copy, *m_export;
  QComboBox *m_quality, *m_cost;
  StudyView* m_view;
  StudyBudgetBar* m_budget;
  QLabel* m_footer;
};

}  // namespace gonio::app
