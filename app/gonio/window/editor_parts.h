// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QSettings>

#include "app/gonio/comparison/comparison_controller.h"
#include "app/gonio/document/document_controller.h"
#include "app/gonio/document/file_exports.h"
#include "app/gonio/document/material_files.h"
#include "app/gonio/export/export_controller.h"
#include "app/gonio/figures/figure_dialog.h"
#include "app/gonio/library/library_controller.h"
#include "app/gonio/library/library_store.h"
#include "app/gonio/matching/match_controller.h"
#include "app/gonio/scene/environment_controller.h"
#include "core/study/representation.h"

namespace gonio::widgets {
class ComparisonBar;
class LibraryView;
class PreviewWidget;
}  // namespace gonio::widgets

namespace gonio::app {

class AcquisitionPanel;
class ComparisonPanel;
class FactorCurvesPanel;
class Inspector;
class InterpolationPanel;
class PhotographPanel;
class PlotsPanel;
class ReferencePanel;
class ScenePanel;
class StudyWindow;
class ViewStrip;

/// The parts of one window: its document, the controllers and the panels, created in this order and connected to each
/// other. The window owns the widgets and deletes them before this object is destroyed, because their destructors may
/// use the document, the controllers and the tasks.
struct EditorParts {
  EditorParts();
  ~EditorParts();

  /// Whether everything requested is displayed.
  bool isSettled() const;
  FigureDialog::Parts figureParts();
  void restoreSettings();
  void saveSettings();

  QSettings settings;
  LibraryStore libraryStore;  ///< stored beside the settings
  RecentFiles recentFiles;
  BackgroundTasks tasks;
  Document document;
  DocumentController controller;
  FileExports exports;
  ExportController exporter;
  LibraryController library;
  widgets::PreviewWidget& preview;
  EnvironmentController environment;
  widgets::LibraryView& libraryView;
  Inspector& inspector;
  widgets::ComparisonBar& comparisonBar;
  ComparisonController comparison;
  ComparisonPanel& comparisonPanel;
  MatchController& match;
  ReferencePanel& referencePanel;
  PlotsPanel& plots;
  FactorCurvesPanel& factors;
  InterpolationPanel& interpolation;
  StudyWindow& study;
  ScenePanel& scene;
  ViewStrip& viewStrip;
  AcquisitionPanel& acquisition;
  PhotographPanel& photographs;

 private:
  void connectStandIns();
  void connectLibrary();
  void connectPlots();
  void takeOldFavourites();
  /// Delays fits and checks of a material until its first picture, so that the processors are free for the preview.
  void connectFirstPicture();
  void use(const gonio::study::Representation& representation);

  void showLoading();

  bool m_awaitsPicture = false;  ///< whether a material or a scene was opened whose first picture is not there yet
  int m_requestsBefore = 0;      ///< the preview's last request for the previous one
};

}  // namespace gonio::app
