// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QDialog>
#include <QSettings>
#include <optional>

#include "app/gonio/study/study_controls.h"
#include "app/gonio/study/study_run.h"
#include "app/gonio/study/study_sheet.h"

class QCheckBox;
class QSortFilterProxyModel;
class QTabWidget;
class QTreeView;

namespace gonio::widgets {
class StudyScatter;
}

namespace gonio::app {

/// Accuracy and cost of the representations that the user ticks, for the open material or for several materials of the
/// library: measured in the background, and shown as a table, as points over a cost, and as a contact sheet, all in the
/// order of the table. A click shows a representation of the open material in the preview (a second click or Escape
/// shows the material again), a double click uses it. It does not change the document, except that it stores fits.
class StudyWindow : public QDialog {
  Q_OBJECT

 public:
  enum Page { ResultsPage, ChartPage, SheetPage };

  StudyWindow(Document& document, BackgroundTasks& tasks, QWidget* parent = nullptr);
  using QDialog::show;

  /// The run that is shown: of the open material or of the library.
  StudyRun& run() const { return *m_run; }
  /// Of the open material, whichever is shown.
  StudyModel& model() const { return m_openRun->model(); }
  QTreeView& table() const { return *m_table; }
  widgets::StudyScatter& scatter() const { return *m_scatter; }
  StudySheet& sheet() const { return *m_sheet; }
  StudyChoice& choice() const { return *m_choice; }
  /// The representation to show in the preview, and its name; nullopt: the material.
  const std::optional<widgets::PreviewSubject>& subject() const { return m_subject; }
  QString shownName() const;

  void restoreState(const QSettings& settings);
  void saveState(QSettings& settings) const;

 public Q_SLOTS:
  /// Brings a page to the front.
  void present(Page page);
  /// Shows the results of the open material, and measures the ticked representations.
  void measureOpen();
  /// Fits and ranks all models, without measuring times.
  void fitAll();
  /// Shows the results of materials of the library.
  void setMaterials(const QStringList& ids);
  /// Shows a row in the preview; the same row again, or -1, shows the material.
  void show(int row);

 Q_SIGNALS:
  void subjectChanged();
  /// The user wants to use this representation.
  void useRequested(const gonio::study::Representation& representation);
  void compareRequested(const std::array<gonio::widgets::PreviewSubject, 2>& subjects,
                        const std::array<QString, 2>& names);
  void saveRequested(const QString& path, const QImage& picture);
  void writeRequested(const QString& path, const gonio::app::FileSave& save);
  void exported(const QString& path);
  void failed(const QString& title, const QString& text);

 protected:
  /// Escape shows the material again, else stops the measurement, else closes the window.
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* buildTop();
  QWidget* buildResults();
  QWidget* buildChart();
  void connectParts();
  void connectRun(StudyRun& run);
  void showRun(StudyRun& run);
  void applyChoice();
  /// The measured rows in the order of the table, and a row by its place among them.
  std::vector<int> rows() const;
  int rowOf(int point) const;
  int pointOf(int row) const;
  bool canShow(int row) const;
  void adopt(int row, const widgets::PreviewSubject& subject);
  void use(int row);
  void exportSvg();
  study::StudyAxes axes() const;
  void sortRows();
  void showColumns();
  void refreshResults();
  void refresh();
  void showModelInUse();
  void refreshBudget();
  void refreshSheet();
  QString hint() const;

  Document& m_document;
  BackgroundTasks& m_tasks;
  StudyRun *m_openRun, *m_libraryRun, *m_run;
  std::optional<widgets::PreviewSubject> m_subject;
  std::vector<int> m_points;                     ///< rows of the points of the chart
  int m_wanted = -1, m_shown = -1, m_best = -1;  ///< rows; m_wanted will be shown when it is ready
  QSortFilterProxyModel* m_sorted;
  QTabWidget* m_pages;
  StudyChoice* m_choice;
  QTreeView* m_table;
  widgets::StudyScatter* m_scatter;
  StudySheet* m_sheet;
  StudyBudgetBar* m_budget;
  QLabel *m_empty, *m_status, *m_footer;
  QPushButton *m_measure, *m_copy, *m_export, *m_back;
  QCheckBox* m_times;
  QComboBox *m_subjects, *m_metric, *m_quality, *m_cost;
};

}  // namespace gonio::app
