// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"
#include "app/gonio/study/study_budget_bar.h"
#include "app/gonio/study/study_model.h"
#include "core/study/machine.h"
#include "core/study/study_plot.h"
#include "widgets/preview/gl/preview_subject.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSortFilterProxyModel;
class QTreeView;

namespace gonio::widgets {
class StudyScatter;
}

namespace gonio::app {

/// What accuracy costs: every representation of the open material, measured in the background, as a table and as points
/// over a cost. A click on either shows that representation in the preview, a second one or Escape the material again.
/// Nothing of it changes the document.
class StudyPanel : public QWidget {
  Q_OBJECT

 public:
  StudyPanel(Document& document, BackgroundTasks& tasks, QWidget* parent = nullptr);

  StudyModel& model() { return m_model; }
  QTreeView* view() const { return m_view; }
  widgets::StudyScatter& scatter() const { return *m_scatter; }
  StudyBudgetBar& budgetBar() const { return *m_budget; }
  bool isRunning() const;
  /// What is measured from now on; all representations by default. Forgets what was measured.
  void setChoice(const study::RepresentationChoice& choice, const study::StudyOptions& options = {});
  /// The representation that the preview is asked to show, with its name; nothing: the material.
  const std::optional<widgets::PreviewSubject>& subject() const { return m_subject; }
  QString shownName() const;
  QString csv() const;

 public Q_SLOTS:
  /// Measures what is missing; where nothing is, all anew.
  void measure();
  /// Shows a row in the preview; the same again, or -1, shows the material.
  void show(int row);

 Q_SIGNALS:
  void subjectChanged();
  /// The user takes this representation into use.
  void taken(const gonio::study::Representation& representation);
  void exported(const QString& path);
  void failed(const QString& title, const QString& text);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void buildControls();
  void buildView();
  void connectParts();
  void start(const LoadedMaterialPtr& material);
  void materialChanged();
  void take(const StudyModel::Studied& studied);
  void adopt(int row, const widgets::PreviewSubject& subject);
  void clicked(const QModelIndex& index);
  void exportSvg();
  std::string studyTitle() const;
  std::string pictures() const;
  study::StudyAxes axes() const;
  void refreshPlot();
  void refresh();

  Document& m_document;
  BackgroundTasks& m_tasks;
  StudyModel m_model;
  study::RepresentationChoice m_choice;
  study::StudyOptions m_options;
  std::optional<study::MachineFacts> m_machine;
  std::optional<widgets::PreviewSubject> m_subject;
  int m_wanted = -1, m_shown = -1, m_best = -1;  ///< rows; `wanted` is shown when it is ready
  QSortFilterProxyModel* m_sorted;
  QPushButton *m_measure, *m_back, *m_copy, *m_export;
  QComboBox *m_quality, *m_cost;
  widgets::StudyScatter* m_scatter;
  QTreeView* m_view;
  StudyBudgetBar* m_budget;
  QLabel *m_empty, *m_footer;
};

}  // namespace gonio::app
