// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/figures/figure_file_buttons.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>

#include "app/gonio/document/file_exports.h"
#include "app/gonio/figures/figure_controller.h"
#include "core/figures/figure_formats.h"
#include "core/figures/figure_tables.h"
#include "core/io/atomic_file.h"
#include "core/support/text.h"
#include "widgets/inputs/dialogs.h"

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
  io::writeFileAtomically(path, suffix == ".csv" ? io::toCsv(figureCsv(figure.description, measurement))
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

namespace {

const QString figurePurpose = QStringLiteral("figure");

/// ".svg" for "SVG (*.svg)".
QString suffixOfFilter(const QString& filter) {
  static const QRegularExpression pattern(QStringLiteral(R"(\*(\.\w+))"));
  return pattern.match(filter).captured(1);
}

/// Appends the suffix of the chosen filter unless the path has one of the offered suffixes.
QString withOfferedSuffix(const QString& path, const QStringList& filters, const QString& chosen) {
  for (const QString& filter : filters)
    if (path.endsWith(suffixOfFilter(filter), Qt::CaseInsensitive)) return path;
  return path + suffixOfFilter(chosen);
}

}  // namespace

FigureFileButtons::FigureFileButtons(FigureController& controller, FileExports& exports, BackgroundTasks& tasks,
                                     QWidget* parent)
    : QWidget(parent),
      m_controller(controller),
      m_exports(exports),
      m_tasks(tasks),
      m_openKey(QStringLiteral("figure description %1").arg(quintptr(this))),
      m_baseName(QStringLiteral("figure")) {
  QPushButton* openButton = button(tr("&Open Description..."), tr("Opens the description of a figure (.json)"),
                                   &FigureFileButtons::askToOpen);
  m_saveDescription =
      button(tr("Save &Description..."),
             tr("Saves the content and layout of the figure (.json); goniotool figure makes the same figure from it"),
             &FigureFileButtons::askForDescription);
  m_saveNumbers = button(tr("Save Num&bers..."), tr("Saves the numbers as CSV or as a LaTeX table"),
                         &FigureFileButtons::askForNumbers);
  m_saveFigure =
      button(tr("Save Fi&gure..."), tr("Saves the figure as PDF, SVG or PNG; missing cells are measured first"),
             &FigureFileButtons::askForFigure);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(openButton);
  layout->addWidget(m_saveDescription);
  layout->addStretch();
  layout->addWidget(m_saveNumbers);
  layout->addWidget(m_saveFigure);
}

FigureFileButtons::~FigureFileButtons() { m_tasks.drop(m_openKey); }

QPushButton* FigureFileButtons::button(const QString& text, const QString& toolTip,
                                       void (FigureFileButtons::*onClick)()) {
  auto* button = new QPushButton(text);
  button->setToolTip(toolTip);
  button->setAutoDefault(false);
  connect(button, &QPushButton::clicked, this, onClick);
  return button;
}

void FigureFileButtons::setSaving(bool enabled) {
  for (QPushButton* button : {m_saveDescription, m_saveNumbers, m_saveFigure}) button->setEnabled(enabled);
}

FigureToWrite FigureFileButtons::figure() const {
  return {
      .description = m_controller.description(), .known = m_controller.known(), .measured = m_controller.collector()};
}

void FigureFileButtons::askForDescription() {
  ask([this] { return figureDescriptionSave(m_controller.description()); }, false);
}
void FigureFileButtons::askForNumbers() {
  ask([this] { return figureNumbersSave(figure()); }, true);
}
void FigureFileButtons::askForFigure() {
  ask([this] { return figureSave(figure()); }, true);
}

void FigureFileButtons::ask(const std::function<FileSave()>& make, bool measures) {
  const FileSave save = make();
  const QStringList filters = save.filter.split(QStringLiteral(";;"));
  auto* dialog = new QFileDialog(this, save.title, widgets::dialogFolder(figurePurpose));
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilters(filters);
  dialog->setDefaultSuffix(save.suffix);
  dialog->selectFile(m_baseName + save.suffix);
  connect(dialog, &QFileDialog::filterSelected, dialog, [this, dialog](const QString& filter) {
    dialog->setDefaultSuffix(suffixOfFilter(filter));
    dialog->selectFile(m_baseName + suffixOfFilter(filter));
  });
  widgets::openFileDialog(dialog, [this, dialog, filters, make, measures](const QString& file) {
    const QString path = withOfferedSuffix(file, filters, dialog->selectedNameFilter());
    widgets::rememberDialogFolder(figurePurpose, path);
    m_baseName = QFileInfo(path).completeBaseName();
    if (measures) m_controller.cancel();
    m_exports.save(path, make());
  });
}

void FigureFileButtons::askToOpen() {
  auto* dialog = new QFileDialog(this, tr("Open Description"), widgets::dialogFolder(figurePurpose),
                                 tr("Figure description (*.json);;All files (*)"));
  dialog->setFileMode(QFileDialog::ExistingFile);
  widgets::openFileDialog(dialog, [this](const QString& path) {
    widgets::rememberDialogFolder(figurePurpose, path);
    open(path);
  });
}

void FigureFileButtons::open(const QString& path) {
  m_tasks.run<figures::FigureDescription>(
      {.title = tr("Reading %1").arg(QFileInfo(path).fileName()), .key = m_openKey, .live = true},
      [path](const TaskControl&) { return figures::readFigureDescription(path.toStdString()); },
      [this, path](const figures::FigureDescription& description) {
        m_baseName = QFileInfo(path).completeBaseName();
        Q_EMIT opened(description);
      },
      [this, path](const QString& error) { showFailure(path, error); });
}

void FigureFileButtons::showFailure(const QString& path, const QString& text) {
  const QString title = tr("Cannot open %1").arg(QFileInfo(path).fileName());
  auto* box = new QMessageBox(QMessageBox::Warning, title, title, QMessageBox::Ok, this);
  box->setInformativeText(text);
  box->setTextFormat(Qt::PlainText);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

}  // namespace gonio::app

#include "moc_figure_file_buttons.cpp"
