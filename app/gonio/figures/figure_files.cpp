// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/figures/figure_files.h"

#include <QCoreApplication>

#include "core/figures/figure_formats.h"
#include "core/figures/figure_tables.h"
#include "core/io/atomic_file.h"
#include "core/support/lower_case.h"

namespace gonio::app {

namespace {

namespace fs = std::filesystem;
using namespace figures;

struct FigureFilesText {
  Q_DECLARE_TR_FUNCTIONS(FigureFiles)
};

/// Call it before the measurement, which may take minutes.
void checkBefore(const FigureDescription& description, const fs::path& path) {
  checkFigureOutput(description, path);
  io::checkWritable(path);
}

FigureMeasurement measuredWhole(const FigureToWrite& figure, const TaskControl& control) {
  return measureFigure(figure.description, control, {.known = figure.known, .measured = figure.measured});
}

void writeNumbers(const FigureToWrite& figure, const fs::path& path, const TaskControl& control) {
  const std::string suffix = lowerCase(path.extension().string());
  if (suffix != ".csv" && suffix != ".tex")
    throw Error(path.string() + ": found the suffix '" + suffix + "', expected .csv or .tex");
  checkBefore(figure.description, path);
  const FigureMeasurement measurement = measuredWhole(figure, control);
  io::writeFileAtomically(path, suffix == ".csv" ? plots::toCsv(figureCsv(figure.description, measurement))
                                                 : figureLatex(figure.description, measurement));
}

}  // namespace

FileSave figureSave(const FigureToWrite& figure) {
  return {FigureFilesText::tr("Save Figure"), QStringLiteral("figure"),
          FigureFilesText::tr("PDF (*.pdf);;SVG (*.svg);;PNG, 300 dots per inch (*.png)"), QStringLiteral(".pdf"),
          [figure](const fs::path& path, const TaskControl& control) {
            const FigureFormat format = figureFormatOf(path);
            checkBefore(figure.description, path);
            const FigureMeasurement measurement = measuredWhole(figure, control);
            io::writeFileAtomically(path, figureFile(figure.description, measurement, format));
          }};
}

FileSave figureNumbersSave(const FigureToWrite& figure) {
  return {FigureFilesText::tr("Save Numbers"), QStringLiteral("figure"),
          FigureFilesText::tr("CSV (*.csv);;LaTeX table (*.tex)"), QStringLiteral(".csv"),
          [figure](const fs::path& path, const TaskControl& control) { writeNumbers(figure, path, control); }};
}

FileSave figureDescriptionSave(const FigureDescription& description) {
  return {FigureFilesText::tr("Save Description"), QStringLiteral("figure"),
          FigureFilesText::tr("Figure description (*.json)"), QStringLiteral(".json"),
          [description](const fs::path& path, const TaskControl&) {
            checkFigure(description);
            checkBefore(description, path);
            io::writeFileAtomically(path, figureDescriptionText(description, path));
          }};
}

}  // namespace gonio::app
