// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QCoreApplication>

#include "app/gonio/figures/figure_dialog.h"
#include "app/gonio/window/action_table.h"
#include "app/gonio/window/dock_layout.h"

class QSettings;

namespace gonio::widgets {
class PreviewContent;
class PreviewWidget;
}  // namespace gonio::widgets

namespace gonio::app {

class AcquisitionPanel;
class BackgroundTasks;
class ComparisonController;
class Document;
class DocumentController;
class DocumentFiles;
class EnvironmentController;
class ExportController;
class Inspector;
class InterpolationPanel;
class LibraryController;
class MatchController;
class PhotographPanel;
class StudyWindow;

/// The rows of the editor's menus, each from the parts that its actions use; these parts must outlive the table.
/// `window` is the parent of dialogs.
struct EditorActions {
  Q_DECLARE_TR_FUNCTIONS(EditorActions)

 public:
  static Action file(DocumentFiles& files, ExportController& exporter, LibraryController& library, DockLayout& docks,
                     const std::function<void()>& openWindow, const std::function<void()>& quit, QWidget* window);
  /// @param notify shows a line in the status bar.
  static Action edit(Document& document, DocumentController& controller, const Inspector& inspector,
                     const widgets::PreviewWidget& preview, QSettings& settings, QAction* showHistory,
                     const std::function<void(const QString&)>& notify, QWidget* window);
  static Action view(DockLayout& docks, ComparisonController& comparison, widgets::PreviewWidget& preview,
                     EnvironmentController& environment, MatchController& match, QSettings& settings, QWidget* window);
  static Action material(DocumentFiles& files, DocumentController& controller, BackgroundTasks& tasks,
                         ComparisonController& comparison, DockLayout& docks, StudyWindow& study,
                         InterpolationPanel& interpolation, AcquisitionPanel& acquisition,
                         PhotographPanel& photographs);
  static Action analyse(const FigureDialog::Parts& figures, ComparisonController& comparison, StudyWindow& study,
                        QWidget* window);
  /// Shows the docks of a workspace; Compare also starts a comparison.
  static void showWorkspace(DockLayout& docks, ComparisonController& comparison, DockLayout::Workspace workspace);
  /// Names of the workspaces, as texts of actions.
  static QStringList workspaceNames();
  /// @param search opens the command search. @param shortcuts returns the page of all shortcuts.
  static Action help(const std::function<void()>& search, const std::function<QString()>& shortcuts, QWidget* window);

 private:
  static std::vector<Action> recentFiles(DocumentFiles& files);
  static std::vector<Action> layouts(DockLayout& docks, ComparisonController& comparison);
  static std::vector<Action> picture(widgets::PreviewWidget& preview);
  static Action toneMap(widgets::PreviewWidget& preview);
  static Action light(EnvironmentController& environment, widgets::PreviewContent& preview, QWidget* window);
  static std::vector<Action> referenceImage(MatchController& match, QWidget* window);
  static Action theme(QSettings& settings);
};

}  // namespace gonio::app
