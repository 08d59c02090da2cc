// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/study_panel.h"

#include <QComboBox>
#include <QFileDialog>
#include <QKeyEvent>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTreeView>
#include <algorithm>

#include "core/io/atomic_file.h"
#include "core/study/study_csv.h"
#include "core/study/study_plot.h"
#include "widgets/study/study_scatter.h"

namespace gonio::app {

namespace {
const QString studyKey = QStringLiteral("study"), showKey = QStringLiteral("study preview");
}

StudyPanel::StudyPanel(Document& document, BackgroundTasks& tasks, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_tasks(tasks),
      m_sorted(new QSortFilterProxyModel(this)),
      m_measure(new QPushButton(this)),
      m_back(new QPushButton(tr("&Back to the Material"), this)),
      m_copy(new QPushButton(tr("Copy as &CSV"), this)),
      m_export(new QPushButton(tr("E&xport as SVG..."), this)),
      m_quality(new QComboBox(this)),
      m_cost(new QComboBox(this)),
      m_scatter(new widgets::StudyScatter(this)),
      m_view(new QTreeView(this)),
      m_budget(new StudyBudgetBar(this)),
      m_empty(new QLabel(m_view)),
      m_footer(new QLabel(this)) {
  buildControls();
  buildView();
  connectParts();
  materialChanged();
}

bool StudyPanel::isRunning() const { return m_tasks.isRunning(studyKey); }

void StudyPanel::setChoice(const study::RepresentationChoice& choice, const study::StudyOptions& options) {
  m_choice = choice;
  m_options = options;
  materialChanged();
}

void StudyPanel::materialChanged() {
  m_tasks.drop(studyKey);
  m_machine.reset();
  m_model.plan(m_document.material() ? study::representationsOf(m_choice) : std::vector<study::Representation>());
  show(-1);
  refreshPlot();
}

void StudyPanel::measure() {
  const LoadedMaterialPtr material = m_document.material();
  if (!material || isRunning()) return;
  if (m_model.missing().empty()) materialChanged();
  start(material);
}

void StudyPanel::start(const LoadedMaterialPtr& material) {
  m_machine = study::machineFacts();
  study::StudyOptions options = m_options;
  // A row is told as it is measured: through the tasks' thread, to a panel that may be gone by then.
  options.measured = [panel = QPointer(this), tasks = &m_tasks, material](const study::StudiedRepresentation& one) {
    const auto studied = std::make_shared<const study::StudiedRepresentation>(one);
    QMetaObject::invokeMethod(
        tasks,
        [panel, material, studied] {
          if (panel && panel->m_document.material() == material) panel->take(studied);
        },
        Qt::QueuedConnection);
  };
  m_tasks.run<bool>(
      {tr("Measuring representations"), studyKey},
      [material, options, missing = m_model.missing()](const TaskControl& control) {
        study::runStudy({material->table, material->material.brdf}, missing, options, control);
        return true;
      },
      [this](bool) { refresh(); },
      [this](const QString& error) { Q_EMIT failed(tr("Cannot measure all representations"), error); });
  refresh();
}

void StudyPanel::take(const StudyModel::Studied& studied) {
  m_model.add(studied);
  refreshPlot();
}

void StudyPanel::show(int row) {
  m_tasks.drop(showKey);
  m_wanted = row < 0 || row == m_shown || row == m_wanted || !m_model.studied(row) ? -1 : row;
  if (m_wanted < 0) {
    const bool was = m_subject.has_value();
    m_subject.reset();
    m_shown = -1;
    refresh();
    if (was) Q_EMIT subjectChanged();
    return;
  }
  m_tasks.run<widgets::PreviewSubject>(
      {tr("Preparing %1").arg(QString::fromStdString(m_model.representation(row).fullLabel())), showKey},
      [studied = m_model.studied(row)](const TaskControl& control) {
        const auto table = studied->tabulated(control);
        return widgets::tableSubject(table, estimateSamplingLobe(*table));
      },
      [this, row](const widgets::PreviewSubject& subject) { adopt(row, subject); },
      [this](const QString& error) {
        m_wanted = -1;
        Q_EMIT failed(tr("Cannot show the representation"), error);
      },
      [this] { m_wanted = -1; });
  refresh();
}

void StudyPanel::adopt(int row, const widgets::PreviewSubject& subject) {
  m_wanted = -1;
  m_shown = row;
  m_subject = subject;
  refresh();
  Q_EMIT subjectChanged();
}

QString StudyPanel::shownName() const {
  return m_shown < 0 ? QString() : QString::fromStdString(m_model.representation(m_shown).fullLabel());
}

std::string StudyPanel::studyTitle() const {
  return m_document.material() ? m_document.material()->material.name : std::string();
}

std::string StudyPanel::pictures() const {
  const RenderOptions& picture = m_options.picture;
  return study::picturesText(picture.width, picture.height, picture.samples);
}

QString StudyPanel::csv() const {
  const auto records = m_model.records();
  return QString::fromStdString(plots::toCsv(
      study::studyCsv("material: " + studyTitle(), records, m_machine.value_or(study::MachineFacts()), pictures())));
}

void StudyPanel::exportSvg() {
  const QString name = QString::fromStdString(studyTitle() + " accuracy.svg").replace('/', '-');
  QString path = QFileDialog::getSaveFileName(this, tr("Export Plot"), name, tr("SVG file (*.svg)"));
  if (path.isEmpty()) return;
  if (!path.endsWith(QStringLiteral(".svg"), Qt::CaseInsensitive)) path += QStringLiteral(".svg");
  try {
    const study::StudyAxes panels[] = {axes()};
    std::vector<std::string> notes = machineLines(*m_machine);
    notes.push_back("pictures and frames: " + pictures());
    io::writeFileAtomically(path.toStdString(), study::studySvg(studyTitle(), m_model.records(), panels, notes));
    Q_EMIT exported(path);
  } catch (const Error& error) {
    Q_EMIT failed(tr("Cannot export the plot"), QString::fromUtf8(error.what()));
  }
}

study::StudyAxes StudyPanel::axes() const {
  study::StudyAxes axes{.cost = study::allCosts[m_cost->currentIndex()], .quality = {}};
  if (const int metric = m_quality->currentIndex() - 1; metric >= 0)
    axes.quality = metrics::metricRecords()[std::size_t(metric)].metric;
  return axes;
}

void StudyPanel::clicked(const QModelIndex& index) {
  if (index.isValid()) show(m_sorted->mapToSource(index).row());
}

bool StudyPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched != m_view || event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
      clicked(m_view->currentIndex());
      return true;
    case Qt::Key_Escape:
      if (!m_subject) return false;
      show(-1);
      return true;
    default:
      return false;
  }
}

void StudyPanel::refreshPlot() {
  m_scatter->setRecords(m_model.records(), axes());
  refresh();
}

void StudyPanel::refresh() {
  const bool open = m_document.material() != nullptr, running = isRunning();
  const auto rows = m_model.measuredRows();
  const bool whole = open && m_model.missing().empty();
  m_measure->setText(running ? tr("Stop") : whole ? tr("Re-&measure") : tr("&Measure"));
  m_measure->setEnabled(open);
  m_back->setVisible(m_subject.has_value());
  for (QPushButton* button : {m_copy, m_export}) button->setEnabled(!rows.empty());
  const auto best = study::bestWithin(m_model.records(), m_budget->budget());
  m_best = best ? rows[*best] : -1;
  m_budget->setEnabled(!rows.empty());
  m_budget->setResult(rows.empty() ? QString()
                      : best ? tr("Best: %1").arg(QString::fromStdString(m_model.representation(m_best).fullLabel()))
                             : tr("None of the %1 measured ones keeps these limits.").arg(rows.size()),
                      best.has_value());
  m_model.setMarks(m_shown, m_best);
  const auto pointOf = [&](int row) {
    const auto found = std::ranges::find(rows, row);
    return found == rows.end() ? -1 : int(found - rows.begin());
  };
  m_scatter->setMarks(pointOf(m_shown), pointOf(m_best));
  const QString hint = !open ? tr("Open a material to see what accuracy costs.")
                       : running
                           ? tr("The first representation is being measured.")
                           : tr("Measure takes some minutes in the background: every way to keep this material, its "
                                "error and what it costs.");
  m_scatter->setHint(hint);
  m_empty->setVisible(!open);
  m_empty->setText(hint);
  QStringList facts;
  if (m_machine)
    for (const std::string& line : machineLines(*m_machine)) facts << QString::fromStdString(line);
  m_footer->setText(facts.join(QStringLiteral(" · ")));
}

}  // namespace gonio::app

#include "moc_study_panel.cpp"
