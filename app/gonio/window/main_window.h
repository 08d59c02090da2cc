// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QMainWindow>
#include <QSettings>

#include "app/gonio/comparison/comparison_controller.h"
#include "app/gonio/document/autosave.h"
#include "app/gonio/document/document_controller.h"
#include "app/gonio/document/recent_files.h"
#include "app/gonio/inspector/inspector.h"
#include "app/gonio/library/library_controller.h"
#include "app/gonio/plots/plots_panel.h"
#include "core/study/representation.h"

namespace gonio::widgets {
class ComparisonBar;
class DropOverlay;
class LibraryView;
class MessageBar;
class PreviewWidget;
class ProgressStrip;
}  // namespace gonio::widgets

class QLabel;
class QUndoView;

namespace gonio::app {

class AcquisitionPanel;
class ComparisonPanel;
class FactorCurvesPanel;
class FitRankingPanel;
class InterpolationPanel;
class StudyPanel;
class ScenePanel;

/// The editor's window: library left, preview in the middle, inspector right. It connects the parts; what they do lies
/// in them. The menus are built by the classes in file_menu.h, edit_menu.h, view_menu.h, analyse_menu.h and
/// help_menu.h.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  Document& document() { return m_document; }
  DocumentController& controller() { return m_controller; }
  BackgroundTasks& tasks() { return m_tasks; }
  LibraryController& library() { return m_libraryController; }
  RecentFiles& recentFiles() { return m_recentFiles; }
  QSettings& settings() { return m_settings; }
  widgets::PreviewWidget& preview() { return *m_preview; }
  widgets::LibraryView& libraryView() { return *m_libraryView; }
  Inspector& inspector() { return *m_inspector; }
  ComparisonController& comparison() { return *m_comparison; }
  PlotsPanel& plots() { return *m_plots; }
  FactorCurvesPanel& factors() { return *m_factors; }
  InterpolationPanel& interpolation() { return *m_interpolation; }
  FitRankingPanel& ranking() { return *m_ranking; }
  StudyPanel& study() { return *m_study; }
  ScenePanel& scenePanel() { return *m_scenePanel; }
  AcquisitionPanel& acquisition() { return *m_acquisition; }
  QList<QDockWidget*> docks() const { return m_docks; }

  /// Opens a file after asking what to do with unsaved changes.
  void open(const QString& path);
  /// Reads a picture in the background and lights the preview with it; a bundled name ("studio", "sky") too; empty
  /// turns the environment off.
  void setEnvironment(const QString& nameOrPath);
  /// Saves under the known path, else asks for one. False when it was not saved.
  bool save();
  bool saveAs();
  void resetLayout();
  /// The Acquisition workspace: its dock, with the preview above it.
  void showAcquisitionLayout();
  /// Brings a dock to the front, or takes it away; by its object name.
  void showDock(const QString& name, bool shown = true);
  /// Offers work that an earlier run left behind.
  void offerRecovery();
  /// Whether everything that was asked for is on the screen.
  bool isSettled() const;

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  /// Raised when docks change in a way that makes a stored layout wrong.
  static constexpr int layoutVersion = 1;

  void buildCentre();
  void buildDocks();
  void buildBottomDocks();
  void connectAcquisition();
  QDockWidget* addDock(const QString& title, const QString& name, QWidget* content, Qt::DockWidgetArea area);
  void buildStatusBar();
  void connectDocument();
  void connectController();
  void showFailure(const QString& title, const QString& text);
  void showTitle();
  void showProgress();
  void showRepresentation();
  void takeRepresentation(const study::Representation& representation);
  bool mayDiscard();
  void restoreSettings();
  void saveSettings();

  QSettings m_settings;
  RecentFiles m_recentFiles;
  BackgroundTasks m_tasks;
  Document m_document;
  DocumentController m_controller;
  LibraryController m_libraryController;
  Autosave m_autosave;
  widgets::PreviewWidget* m_preview;
  widgets::LibraryView* m_libraryView;
  Inspector* m_inspector;
  widgets::ComparisonBar* m_comparisonBar;
  ComparisonController* m_comparison;
  ComparisonPanel* m_comparisonPanel;
  PlotsPanel* m_plots;
  FactorCurvesPanel* m_factors;
  FitRankingPanel* m_ranking;
  InterpolationPanel* m_interpolation;
  StudyPanel* m_study;
  ScenePanel* m_scenePanel;
  AcquisitionPanel* m_acquisition;
  widgets::MessageBar* m_messages;
  widgets::ProgressStrip* m_progress;
  widgets::DropOverlay* m_dropOverlay;
  QUndoView* m_history;
  QLabel *m_representation, *m_samples, *m_frameTime;
  QList<QDockWidget*> m_docks;
  QByteArray m_defaultLayout;
};

}  // namespace gonio::app
