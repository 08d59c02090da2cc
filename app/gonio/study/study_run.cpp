// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/study_run.h"

#include <QPointer>

#include "app/gonio/document/material_files.h"
#include "app/gonio/library/thumbnail.h"
#include "core/io/atomic_file.h"

namespace gonio::app {

StudyRun::StudyRun(Subject subject, Document& document, BackgroundTasks& tasks, QObject* parent)
    : QObject(parent),
      m_subject(subject),
      m_document(document),
      m_tasks(tasks),
      m_key(QStringLiteral("study %1").arg(quintptr(this))) {
  if (subject == Subject::openMaterial)
    connect(&m_document, &Document::materialChanged, this, &StudyRun::documentChanged);
  connect(&m_tasks, &BackgroundTasks::changed, this, [this] {
    if (std::exchange(m_wasRunning, isRunning()) != isRunning()) Q_EMIT runningChanged();
  });
  m_model.plan(study::representationsOf(m_choice));
}

StudyRun::~StudyRun() { m_tasks.drop(m_key); }

void StudyRun::documentChanged() {
  m_tasks.drop(m_key);
  m_wasRunning = false;
  m_model.outdate();
  Q_EMIT restarted();
}

void StudyRun::setMaterials(const QStringList& ids) {
  if (ids == m_ids) return;
  m_tasks.drop(m_key);
  m_wasRunning = false;
  std::vector<int> before;
  for (const QString& id : ids) before.push_back(int(m_ids.indexOf(id)));
  m_ids = ids;
  std::vector<std::string> names;
  for (const QString& name : distinctNames(ids)) names.push_back(name.toStdString());
  m_failures.assign(names.size(), {});
  m_model.setMaterials(std::move(names), before);
  if (m_model.isEmpty()) m_machine.reset();
  Q_EMIT restarted();
}

void StudyRun::setChoice(const study::RepresentationChoice& choice) {
  m_tasks.drop(m_key);
  m_wasRunning = false;
  m_choice = choice;
  m_model.plan(study::representationsOf(choice));
  Q_EMIT restarted();
}

bool StudyRun::canMeasure() const {
  const bool hasMaterial = m_subject == Subject::library ? !m_ids.isEmpty() : m_document.material() != nullptr;
  return hasMaterial && m_model.rowCount() > 0;
}

bool StudyRun::isRunning() const { return m_tasks.isRunning(m_key); }

bool StudyRun::isComplete(bool timed) const {
  for (std::size_t i = 0; i < m_failures.size(); ++i)
    if (m_failures[i].isEmpty() && !m_model.missing(i, timed).empty()) return false;
  return true;
}

void StudyRun::cancel() { m_tasks.cancel(m_key); }

std::vector<study::Representation> StudyRun::wanted(std::size_t material) const {
  std::vector<study::Representation> rows = m_model.missing(material, m_request.timed);
  if (!m_request.family.empty())
    std::erase_if(rows, [&](const study::Representation& one) { return one.kind->family->id != m_request.family; });
  return rows;
}

std::optional<std::size_t> StudyRun::nextMaterial() const {
  for (std::size_t i = 0; i < m_failures.size(); ++i)
    if (m_failures[i].isEmpty() && !wanted(i).empty()) return i;
  return std::nullopt;
}

void StudyRun::measure(const Request& request) {
  if (!canMeasure() || isRunning()) return;
  m_request = request;
  std::ranges::fill(m_failures, QString());
  if (!nextMaterial()) {
    std::vector<study::Representation> again;
    for (int row = 0; row < m_model.rowCount(); ++row)
      if (request.family.empty() || m_model.representation(row).kind->family->id == request.family)
        again.push_back(m_model.representation(row));
    m_model.requestAgain(again);
  }
  m_machine = study::machineFacts();
  measureNext();
}

void StudyRun::measureNext() {
  if (const auto next = nextMaterial(); next && !isRunning()) start(*next);
  Q_EMIT runningChanged();
}

void StudyRun::start(std::size_t material) {
  const LoadedMaterialPtr loaded = m_subject == Subject::openMaterial ? m_document.material() : nullptr;
  study::StudyOptions options = m_options;
  options.timed = m_request.timed;
  // A row is reported as it is measured: through the tasks' thread, to a run that may be gone by then.
  options.measured = [run = QPointer(this), tasks = &m_tasks, material, loaded,
                      ids = m_ids](const study::MeasuredRepresentation& one) {
    auto studied = std::make_shared<study::MeasuredRepresentation>(one);
    QMetaObject::invokeMethod(
        tasks,
        [run, material, loaded, ids, studied] {
          if (run && run->m_ids == ids && (!loaded || run->m_document.material() == loaded))
            run->add(material, loaded, studied);
        },
        Qt::QueuedConnection);
  };
  const QString name =
      widgets::spacedName(loaded ? m_document.name() : QString::fromStdString(m_model.materials()[material]));
  const QString title = m_ids.size() < 2 ? tr("Measuring representations of %1").arg(name)
                                         : tr("Measuring %1 (%2 of %3)").arg(name).arg(material + 1).arg(m_ids.size());
  m_tasks.run<bool>(
      {.title = title, .key = m_key, .isLong = true},
      [loaded, id = m_ids.value(qsizetype(material)), options, rows = wanted(material)](const TaskControl& control) {
        if (loaded) {
          study::runStudy({loaded->table(control), loaded->material.brdf}, rows, options, control);
        } else {
          const materials::Material read = libraryMaterial(id, control);
          study::runStudy({read.tabulated(control), read.brdf}, rows, options, control);
        }
        return !control.stop.stop_requested();
      },
      [this](bool complete) { complete ? measureNext() : runningChanged(); },
      [this, material](const QString& error) {
        if (m_subject == Subject::openMaterial) Q_EMIT failed(tr("Cannot measure all representations"), error);
        m_failures[material] = error;
        measureNext();
      },
      [this] { Q_EMIT runningChanged(); });
}

void StudyRun::add(std::size_t material, const LoadedMaterialPtr& loaded, const StudyModel::Studied& studied) {
  if (loaded) {
    m_material = loaded;
    m_name = m_document.name();
    if (studied->fit && !studied->fit->cancelled) m_document.rememberFit(*studied->fit);
  }
  m_model.add(material, studied);
  Q_EMIT rowMeasured();
}

QString StudyRun::title() const {
  if (m_subject == Subject::library)
    return m_ids.isEmpty() ? QString() : m_ids.size() == 1 ? tr("1 material") : tr("%1 materials").arg(m_ids.size());
  return m_model.isEmpty() ? QString() : m_name;
}

QString StudyRun::status() const {
  QStringList lines;
  std::size_t done = 0;
  for (std::size_t i = 0; i < m_failures.size(); ++i)
    if (m_subject == Subject::library && !m_failures[i].isEmpty())
      lines << tr("%1 is excluded: %2")
                   .arg(QString::fromStdString(m_model.materials()[i]), m_failures[i].section('\n', 0, 0));
    else if (m_model.missing(i).empty())
      ++done;
  const auto next = nextMaterial();
  if (m_subject == Subject::openMaterial) {
    int measured = 0;
    for (int row = 0; row < m_model.rowCount(); ++row) measured += m_model.isMeasured(row);
    if (m_model.isOutdated())
      lines << tr("These are results of %1. Press Measure to replace them with those of %2.")
                   .arg(widgets::spacedName(m_name), widgets::spacedName(m_document.name()));
    else if (measured > 0)
      lines << tr("%1: %2 of %3 representations are measured.")
                   .arg(widgets::spacedName(m_name))
                   .arg(measured)
                   .arg(m_model.rowCount());
  } else if (!m_ids.isEmpty() && m_model.rowCount() > 0) {
    QString first = tr("%1 of %2 materials are measured.").arg(done).arg(m_ids.size());
    if (isRunning() && next)
      first += ' ' + tr("Measuring %1.").arg(widgets::spacedName(QString::fromStdString(m_model.materials()[*next])));
    lines.prepend(first);
  }
  return lines.join('\n');
}

std::vector<std::string> StudyRun::machine() const {
  return m_machine ? machineLines(*m_machine) : std::vector<std::string>();
}

std::string StudyRun::pictures() const {
  const rendering::RenderOptions& picture = m_options.picture;
  return study::picturesText(picture.width, picture.height, picture.samples);
}

QString StudyRun::csv(const std::vector<int>& rows) const {
  return m_model.csv(rows, title().toStdString(), m_machine.value_or(study::MachineFacts()), pictures());
}

void StudyRun::writeSvg(const QString& path, const study::StudyAxes& axes, const std::vector<int>& rows) const {
  const study::StudyAxes panels[] = {axes};
  std::vector<std::string> notes = machine();
  notes.push_back("images and frame times: " + pictures());
  io::writeFileAtomically(path.toStdString(),
                          study::studySvg(title().toStdString(), m_model.records(rows), panels, notes));
}

}  // namespace gonio::app

#include "moc_study_run.cpp"
#include "widgets/inputs/menu_text.h"
