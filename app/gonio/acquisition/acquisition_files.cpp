// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/acquisition_files.h"

#include <QComboBox>
#include <QFileDialog>

#include "core/acquisition/plan_file.h"
#include "core/acquisition/values_file.h"
#include "widgets/inputs/dialog_folder.h"

namespace gonio::app {

namespace {
const QString planFolder = QStringLiteral("acquisition");

void remember(const QString& path) { widgets::rememberDialogFolder(planFolder, path); }
}  // namespace

AcquisitionFiles::AcquisitionFiles(AcquisitionSession& session, AcquisitionControls& controls,
                                   MeasuredMaterialSource& source, QWidget* panel)
    : QObject(panel), m_session(session), m_controls(controls), m_source(source), m_panel(panel) {}

std::vector<std::string> AcquisitionFiles::planComments() const {
  const PlanSettings& settings = m_session.planner().settings();
  return {tr("Plan of %n samples, %1", nullptr, int(m_session.planner().samplingPlan().samples.size()))
              .arg(m_controls.directions().methodBox().itemText(int(settings.method)))
              .toStdString(),
          tr("learned from %n materials (%1)", nullptr, m_session.planner().learnedMaterials())
              .arg(settings.training.name)
              .toStdString()};
}

QString AcquisitionFiles::planText() const {
  return QString::fromStdString(acquisition::planCsv(m_session.planner().samplingPlan(), planComments()));
}

void AcquisitionFiles::savePlan(const QString& path) {
  try {
    acquisition::writePlan(m_session.planner().samplingPlan(), path.toStdString(), planComments());
    Q_EMIT exported(path);
  } catch (const Error& error) {
    Q_EMIT failed(tr("Cannot save the plan"), QString::fromUtf8(error.what()));
  }
}

void AcquisitionFiles::readPlan(const QString& path) {
  try {
    const acquisition::SamplingPlan plan = acquisition::readPlan(path.toStdString());
    m_source.takeOpenMaterial();
    m_controls.directions().setSamples(int(plan.samples.size()));
    m_session.plan(m_controls.planSettings(), plan);
  } catch (const Error& error) {
    Q_EMIT failed(tr("Cannot open the plan"), QString::fromUtf8(error.what()));
  }
}

void AcquisitionFiles::paste(const QString& text) {
  try {
    if (text.trimmed().isEmpty()) throw Error(tr("There is no text on the clipboard.").toStdString());
    m_session.setValues(acquisition::parseValues(text.toStdString(), m_session.planner().samplingPlan()), tr("pasted"));
  } catch (const Error& error) {
    Q_EMIT failed(tr("Cannot use the values"), QString::fromUtf8(error.what()));
  }
}

void AcquisitionFiles::readValues(const QString& path) {
  try {
    m_session.setValues(acquisition::readValues(path.toStdString(), m_session.planner().samplingPlan()),
                        path.section('/', -1));
  } catch (const Error& error) {
    Q_EMIT failed(tr("Cannot use the values"), QString::fromUtf8(error.what()));
  }
}

QFileDialog* AcquisitionFiles::openDialog(const QString& title, const QString& filter) {
  auto* dialog = new QFileDialog(m_panel, title, widgets::dialogFolder(planFolder), filter);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, remember);
  dialog->open();
  return dialog;
}

QFileDialog* AcquisitionFiles::saveDialog(const QString& title, const QString& filter, const QString& name) {
  const QString suffix = QStringLiteral("csv");
  auto* dialog = new QFileDialog(m_panel, title, widgets::dialogFolder(planFolder), filter);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(suffix);
  if (!name.isEmpty()) dialog->selectFile(name + '.' + suffix);
  connect(dialog, &QFileDialog::fileSelected, this, remember);
  dialog->open();
  return dialog;
}

void AcquisitionFiles::askForPlan() {
  connect(openDialog(tr("Open Plan"), tr("Plans (*.csv);;All files (*)")), &QFileDialog::fileSelected, this,
          &AcquisitionFiles::readPlan);
}

void AcquisitionFiles::askForValues() {
  connect(openDialog(tr("Open Values"), tr("Values (*.csv *.txt);;All files (*)")), &QFileDialog::fileSelected, this,
          &AcquisitionFiles::readValues);
}

void AcquisitionFiles::askForPlanFile() {
  connect(saveDialog(tr("Save Plan"), tr("Plan (*.csv)")), &QFileDialog::fileSelected, this,
          &AcquisitionFiles::savePlan);
}

}  // namespace gonio::app

#include "moc_acquisition_files.cpp"
