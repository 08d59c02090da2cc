// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/acquisition/acquisition_controls.h"
#include "app/gonio/acquisition/acquisition_sample_model.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSlider;
class QTabWidget;
class QTableView;

namespace gonio::widgets {
class ErrorCurve;
class HalfDifferenceChart;
class HemisphereChart;
class ReconstructionView;
class SampleChart;
}  // namespace gonio::widgets

namespace gonio::app {

/// The Acquisition workspace: where a material is to be measured, and the whole material from what was measured there.
/// Nothing of it changes the document until the result is opened, which is an undo step.
class AcquisitionPanel : public QWidget {
  Q_OBJECT

 public:
  enum Page { samplesPage, reconstructionPage, curvePage };

  AcquisitionPanel(Document& document, BackgroundTasks& tasks, QWidget* parent = nullptr);

  AcquisitionSession& session() { return m_session; }
  AcquisitionControls& controls() const { return *m_controls; }
  widgets::HemisphereChart& hemisphere() const { return *m_hemisphere; }
  widgets::HalfDifferenceChart& chart() const { return *m_chart; }
  widgets::ReconstructionView& view() const { return *m_view; }
  widgets::ErrorCurve& curve() const { return *m_curve; }
  QTableView& table() const { return *m_table; }
  QTabWidget& pages() const { return *m_pages; }
  QPushButton& startButton() const { return *m_start; }
  QPushButton& openButton() const { return *m_open; }
  /// What it says of what was done and what can be done next.
  QString status() const;
  /// What the result's numbers are.
  QString numbers() const;
  /// The plan as comma-separated text, with what it was made for in comments.
  QString planText() const;
  /// Nothing is to come.
  bool isSettled() const;

 public Q_SLOTS:
  /// Chooses directions with the present settings; while it works: stops.
  void start();
  /// Values as comma-separated text, one row a sample. Tells what is wrong with them.
  void paste(const QString& text);
  void readValues(const QString& path);
  /// A plan that was saved before, here or by goniotool: learns the training set and takes its directions.
  void readPlan(const QString& path);
  void savePlan(const QString& path);
  /// The material that is measured: a file or one of the library.
  void measure(const QString& id);
  /// The result becomes the document's material: one undo step.
  void openResult();

 Q_SIGNALS:
  /// The user wants to choose the material that is measured.
  void subjectWanted();
  void exported(const QString& path);
  void failed(const QString& title, const QString& text);

 protected:
  void showEvent(QShowEvent* event) override;
  QSize sizeHint() const override;

 private:
  QWidget* buildControls();
  QWidget* buildCharts();
  QWidget* buildPages();
  QWidget* buildSamplesPage();
  QWidget* buildReconstructionPage();
  QWidget* buildCurvePage();
  void connectSession();
  void connectCharts();
  void connectButtons();
  void askForValues();
  void askForPlanFile();
  void askForPlan();
  /// The document's material, where that is what is measured.
  void takeOpenMaterial();
  bool startCancels() const;
  void subjectEdited();
  void mark(int sample);
  void showDirections();
  void showSlice();
  void showReference();
  void showResult();
  void showCurve();
  void refresh();
  QStringList planComments() const;
  QString nextStep() const;

  Document& m_document;
  AcquisitionSession m_session;
  AcquisitionSampleModel m_model;
  LoadedMaterialPtr m_taken;  ///< whose table is the reference
  std::vector<editing::Edit> m_takenEdits;
  bool m_pageChosen = false;  ///< by the user, since the last start
  AcquisitionControls* m_controls;
  QPushButton *m_start, *m_open, *m_copy, *m_save, *m_openPlan, *m_paste, *m_read;
  QProgressBar* m_progress;
  QLabel *m_status, *m_numbers;
  widgets::HemisphereChart* m_hemisphere;
  widgets::HalfDifferenceChart* m_chart;
  QSlider* m_slice;
  QLabel* m_sliceText;
  QCheckBox* m_uncertainty;
  QTabWidget* m_pages;
  QTableView* m_table;
  widgets::ReconstructionView* m_view;
  QComboBox* m_quality;
  widgets::ErrorCurve* m_curve;
};

}  // namespace gonio::app
