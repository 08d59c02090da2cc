// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/study_run.h"

#include <QPointer>

#include "core/io/atomic_file.h"
#include "core/study/study_record.h"

namespace gonio::app {

namespace {
const QString studyKey = QStringLiteral("study");
}

StudyRun::StudyRun(const Document& document, BackgroundTasks& tasks, StudyModel& model, QObject* parent)
    : QObject(parent), m_document(document), m_tasks(tasks), m_model(model) {
  connect(&m_document, &Document::materialChanged, this, &StudyRun::restart);
  connect(&m_tasks, &BackgroundTasks::changed, this, [this] {
    if (std::exchange(m_wasRunning, isRunning()) != isRunning()) Q_EMIT runningChanged();
  });
  restart();
}

bool StudyRun::isRunning() const { return m_tasks.isRunning(studyKey); }

void StudyRun::cancel() { m_tasks.cancel(studyKey); }

void StudyRun::setChoice(const study::RepresentationChoice& choice, const study::StudyOptions& options) {
  m_choice = choice;
  m_options = options;
  restart();
}

void StudyRun::restart() {
  m_tasks.drop(studyKey);
  m_wasRunning = false;
  m_machine.reset();
  m_model.plan(planned());
  Q_EMIT restarted();
}

void StudyRun::setFamilies(const std::vector<std::string>& families) {
  m_choice.names = families;
  m_tasks.drop(studyKey);
  m_model.replan(planned());
  Q_EMIT restarted();
}

std::vector<study::Representation> StudyRun::planned() const {
  return m_document.material() ? study::representationsOf(m_choice) : std::vector<study::Representation>();
}

void StudyRun::measure() {
  const LoadedMaterialPtr material = m_document.material();
  if (!material || isRunning()) return;
  if (m_model.missing().empty()) restart();
  start(material);
}

void StudyRun::start(const LoadedMaterialPtr& material) {
  m_machine = study::machineFacts();
  study::StudyOptions options = m_options;
  // A row is reported as it is measured: through the tasks' thread, to a run that may be gone by then.
  options.measured = [run = QPointer(this), tasks = &m_tasks, material](const study::MeasuredRepresentation& one) {
    const auto studied = std::make_shared<const study::MeasuredRepresentation>(one);
    QMetaObject::invokeMethod(
        tasks,
        [run, material, studied] {
          if (!run || run->m_document.material() != material) return;
          run->m_model.add(studied);
          Q_EMIT run->rowMeasured();
        },
        Qt::QueuedConnection);
  };
  m_tasks.run<bool>(
      {tr("Measuring representations"), studyKey},
      [material, options, missing = m_model.missing()](const TaskControl& control) {
        study::runStudy({material->table(control), material->material.brdf}, missing, options, control);
        return true;
      },
      [](bool) {}, [this](const QString& error) { Q_EMIT failed(tr("Cannot measure all representations"), error); });
}

std::string StudyRun::title() const { return m_document.material() ? m_document.name().toStdString() : std::string(); }

std::vector<std::string> StudyRun::machine() const {
  return m_machine ? machineLines(*m_machine) : std::vector<std::string>();
}

std::string StudyRun::pictures() const {
  const RenderOptions& picture = m_options.picture;
  return study::picturesText(picture.width, picture.height, picture.samples);
}

QString StudyRun::csv() const {
  return QString::fromStdString(io::toCsv(study::studyCsv("material: " + title(), m_model.records(),
                                                          m_machine.value_or(study::MachineFacts()), pictures())));
}

void StudyRun::writeSvg(const QString& path, const study::StudyAxes& axes) const {
  const study::StudyAxes panels[] = {axes};
  std::vector<std::string> notes = machine();
  notes.push_back("images and frame times: " + pictures());
  io::writeFileAtomically(path.toStdString(), study::studySvg(title(), m_model.records(), panels, notes));
}

}  // namespace gonio::app

#include "moc_study_run.cpp"
