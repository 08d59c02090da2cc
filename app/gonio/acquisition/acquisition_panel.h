// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/acquisition/acquisition_controls.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTabWidget;

namespace gonio::app {

class AcquisitionCharts;
class AcquisitionFiles;
class MeasuredMaterialSource;
class ErrorCurvePage;
class FactorPage;
class ReconstructionPage;
class SamplesPage;

/// The left column of a panel: controls that scroll, and below them a button that starts and stops the work, its
/// progress (0 to 1000) and a text of at least two lines. @param ems width, in heights of the font.
QWidget* controlColumn(QWidget& controls, QPushButton& start, QProgressBar& progress, QLabel& status, int ems);

/// The Acquisition workspace: selects the directions of a measurement and reconstructs the whole material from the
/// measured values. The document does not change until the result is opened, which is an undo step.
class AcquisitionPanel : public QWidget {
  Q_OBJECT

 public:
  enum Page { samplesPage, reconstructionPage, curvePage, factorPage };

  AcquisitionPanel(Document& document, BackgroundTasks& tasks, QWidget* parent = nullptr);

  AcquisitionSession& session() { return m_session; }
  AcquisitionControls& controls() const { return *m_controls; }
  AcquisitionFiles& files() const { return *m_files; }
  AcquisitionCharts& charts() const { return *m_charts; }
  SamplesPage& samples() const { return *m_samples; }
  ReconstructionPage& reconstruction() const { return *m_reconstruction; }
  ErrorCurvePage& curve() const { return *m_curve; }
  FactorPage& factors() const { return *m_factors; }
  QTabWidget& pages() const { return *m_pages; }
  QPushButton& startButton() const { return *m_start; }
  /// Description of the current state and of the possible next step.
  QString status() const;
  /// Whether no work is pending.
  bool isSettled() const;

 public Q_SLOTS:
  /// Selects directions with the current settings, or stops the running work.
  void start();
  /// Sets the measured material. @param id a file or a material of the library.
  void measure(const QString& id);

 Q_SIGNALS:
  /// The user wants to choose the measured material.
  void measuredMaterialRequested();
  void exported(const QString& path);
  /// As AcquisitionSession::materialMade().
  void materialMade(const LoadedMaterialPtr& material, const QString& text);
  void failed(const QString& title, const QString& text);

 protected:
  void showEvent(QShowEvent* event) override;
  QSize sizeHint() const override;

 private:
  void connectSession();
  void connectParts();
  void mark(int sample);
  void showResultPage();
  void refresh();
  void openResult();
  void openPrediction();

  AcquisitionSession m_session;
  bool m_pageChosen = false;  ///< whether the user has chosen a page since the last start
  AcquisitionControls* m_controls;
  MeasuredMaterialSource* m_source;
  AcquisitionFiles* m_files;
  AcquisitionCharts* m_charts;
  SamplesPage* m_samples;
  ReconstructionPage* m_reconstruction;
  ErrorCurvePage* m_curve;
  FactorPage* m_factors;
  QTabWidget* m_pages;
  QPushButton* m_start;
  QProgressBar* m_progress;
  QLabel* m_status;
};

}  // namespace gonio::app
