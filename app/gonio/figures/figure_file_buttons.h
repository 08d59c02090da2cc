// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <functional>

#include "app/gonio/document/file_exports.h"
#include "core/figures/figure_measurement.h"

class QPushButton;

namespace gonio::app {

/// The input of an output file, as it was when the user asked for the file.
struct FigureToWrite {
  figures::FigureDescription description;
  figures::FigureMeasurement known;  ///< missing cells are measured before the file is written
  std::function<void(const figures::FigureMeasurement&)> measured = {};  ///< receives the new results
};

/// The figure as .pdf, .svg or .png, for FileExports::save(). The suffix of the path selects the format. This and the
/// other output files of a figure cannot overwrite its sources.
FileSave figureSave(const FigureToWrite& figure);
/// The numbers of the figure: .csv, or .tex for LaTeX.
FileSave figureNumbersSave(const FigureToWrite& figure);
/// The description of the figure: .json.
FileSave figureDescriptionSave(const figures::FigureDescription& description);

class BackgroundTasks;
class FigureController;
class FileExports;

/// Buttons that open and save the description of a figure, and save the figure and its numbers.
class FigureFileButtons : public QWidget {
  Q_OBJECT

 public:
  FigureFileButtons(FigureController& controller, FileExports& exports, BackgroundTasks& tasks,
                    QWidget* parent = nullptr);
  ~FigureFileButtons() override;

  /// Reads a description in the background.
  void open(const QString& path);
  /// Enables the buttons that save.
  void setSaving(bool enabled);

 Q_SIGNALS:
  void opened(const gonio::figures::FigureDescription& description);

 private:
  QPushButton* button(const QString& text, const QString& toolTip, void (FigureFileButtons::*onClick)());
  void askToOpen();
  void askForDescription();
  void askForNumbers();
  void askForFigure();
  /// Asks for a name, then writes what `make` returns at that moment. @param measures whether writing the file measures
  /// the missing cells; then a measurement for the page is cancelled.
  void ask(const std::function<FileSave()>& make, bool measures);
  FigureToWrite figure() const;
  void showFailure(const QString& path, const QString& text);

  FigureController& m_controller;
  FileExports& m_exports;
  BackgroundTasks& m_tasks;
  const QString m_openKey;
  QString m_baseName;  ///< of the last opened or saved file
  QPushButton *m_saveDescription, *m_saveNumbers, *m_saveFigure;
};

}  // namespace gonio::app
