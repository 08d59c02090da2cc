// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/acquisition_files.h"

#include <QComboBox>
#include <QFileDialog>

#include "core/acquisition/measured_values.h"
#include "core/acquisition/sampling_plan.h"
#include "widgets/inputs/dialogs.h"

namespace gonio::app {

using Choice = MeasuredMaterialRows::Choice;

MeasuredMaterialSource::MeasuredMaterialSource(const Document& document, AcquisitionSession& session,
                                               AcquisitionControls& controls)
    : QObject(&controls), m_document(document), m_session(session), m_controls(controls) {
  connect(&m_document, &Document::materialChanged, this, &MeasuredMaterialSource::takeOpenMaterial);
  connect(&m_controls.measuredMaterial(), &MeasuredMaterialRows::edited, this, &MeasuredMaterialSource::edited);
  connect(&m_session.referenceReader(), &ReferenceReader::changed, this, &MeasuredMaterialSource::showReference);
}

void MeasuredMaterialSource::takeOpenMaterial() {
  if (m_controls.measuredMaterial().choice() != Choice::openMaterial || !m_controls.isVisible()) return;
  const LoadedMaterialPtr material = m_document.material();
  const std::vector<editing::Edit> edits = m_document.edits();
  const auto base = m_document.base();
  if (base == m_taken && edits == m_takenEdits && m_session.referenceReader().name() == m_document.name()) return;
  m_taken = base;
  m_takenEdits = edits;
  if (!material) return m_session.referenceReader().clear();
  m_session.referenceReader().read(
      QString::fromStdString(material->material.source.path.string()), m_document.name(),
      [base, edits](const TaskControl& control) { return editing::bakeEdits(base, edits, control); });
}

void MeasuredMaterialSource::edited() {
  m_taken.reset();
  if (m_controls.measuredMaterial().choice() == Choice::none) m_session.referenceReader().clear();
  if (m_controls.measuredMaterial().choice() == Choice::openMaterial) takeOpenMaterial();
  if (m_controls.measuredMaterial().choice() == Choice::chosen)
    m_session.referenceReader().read(m_controls.measuredMaterial().chosenId());
}

void MeasuredMaterialSource::choose(const QString& id) {
  m_session.referenceReader().read(id);
  m_controls.measuredMaterial().choose(id, m_session.referenceReader().name());
}

void MeasuredMaterialSource::fixOpenMaterial() {
  if (m_controls.measuredMaterial().choice() == Choice::openMaterial && m_session.referenceReader().reference())
    m_controls.measuredMaterial().choose(m_session.referenceReader().id(), m_session.referenceReader().name());
}

void MeasuredMaterialSource::showReference() {
  if (m_controls.measuredMaterial().choice() == Choice::chosen && !m_session.referenceReader().name().isEmpty())
    m_controls.measuredMaterial().choose(m_session.referenceReader().id(), m_session.referenceReader().name());
  m_controls.training().setMeasuredId(m_session.referenceReader().id());
}

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
