// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/study_summary_window.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTreeView>
#include <algorithm>

#include "app/gonio/document/material_files.h"
#include "app/gonio/library/thumbnail.h"
#include "app/gonio/study/study_run.h"
#include "core/study/study_record.h"
#include "widgets/panels/sorted_table.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {

std::vector<std::string> namesOf(const QStringList& ids) {
  std::vector<std::string> names;
  for (const QString& name : distinctNames(ids)) names.push_back(name.toStdString());
  return names;
}

}  // namespace

StudySummaryWindow::StudySummaryWindow(BackgroundTasks& tasks, const QStringList& ids, QWidget* parent)
    : QDialog(parent),
      m_tasks(tasks),
      m_ids(ids),
      m_model(namesOf(ids)),
      m_machine(study::machineFacts()),
      m_failures(std::size_t(ids.size())),
      m_key(QStringLiteral("study-summary %1").arg(quintptr(this))),
      m_sorted(new QSortFilterProxyModel(this)),
      m_table(new QTreeView),
      m_measure(new QPushButton),
      m_copy(new QPushButton(tr("Copy as &CSV"))),
      m_empty(new QLabel(m_table)),
      m_status(new QLabel),
      m_footer(new QLabel) {
  setWindowTitle(tr("Study of %1 Materials").arg(ids.size()));
  build();
  connect(m_measure, &QPushButton::clicked, this, [this] { isRunning() ? cancel() : measure(); });
  connect(m_copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(csv()); });
  connect(&m_tasks, &BackgroundTasks::changed, this, &StudySummaryWindow::refresh);
  planFamilies();
}

StudySummaryWindow::~StudySummaryWindow() { m_tasks.drop(m_key); }

void StudySummaryWindow::build() {
  const int em = fontMetrics().height();
  resize(em * 71, em * 36);
  widgets::setUpSortedTable(*m_table, *m_sorted, m_model, *m_empty);
  m_table->sortByColumn(StudySummaryModel::MedianSnrColumn, Qt::AscendingOrder);
  m_table->setAccessibleName(tr("Representations over all materials"));
  m_table->header()->setStretchLastSection(false);
  const int widths[] = {17, 5, 8, 7, 9, 4, 7, 5, 6};
  for (int column = 0; column < StudySummaryModel::ColumnCount; ++column)
    m_table->header()->resizeSection(column, std::max(m_table->header()->sectionSizeHint(column), widths[column] * em));
  m_copy->setToolTip(tr("Copies the table, with the errors in every metric, as comma-separated text"));
  for (QPushButton* button : {m_measure, m_copy}) button->setAutoDefault(false);
  m_status->setTextFormat(Qt::PlainText);
  m_status->setWordWrap(true);
  m_footer->setForegroundRole(QPalette::PlaceholderText);
  QStringList machine;
  for (const std::string& line : machineLines(m_machine)) machine << QString::fromStdString(line);
  m_footer->setText(machine.join(QStringLiteral(" · ")));
  m_footer->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  m_footer->setToolTip(machine.join('\n'));
  auto* top = new QHBoxLayout;
  top->addWidget(m_measure);
  top->addWidget(buildFamilies());
  top->addStretch();
  top->addWidget(m_copy);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(top);
  layout->addWidget(m_table, 1);
  layout->addWidget(m_status);
  layout->addWidget(m_footer);
}

QWidget* StudySummaryWindow::buildFamilies() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  const auto chosen = study::defaultFamilies(), offered = study::familiesWithoutFurtherData();
  for (const study::RepresentationFamily* family : study::representationFamilies()) {
    if (!std::ranges::count(offered, family->id)) continue;
    auto* box = new QCheckBox(widgets::toQString(family->name));
    box->setChecked(std::ranges::count(chosen, family->id) > 0);
    box->setToolTip(widgets::toQString(family->hint));
    connect(box, &QCheckBox::toggled, this, &StudySummaryWindow::planFamilies);
    layout->addWidget(box);
    m_families.push_back(box);
  }
  return row;
}

void StudySummaryWindow::planFamilies() {
  study::RepresentationChoice choice;
  choice.names.clear();
  const auto offered = study::familiesWithoutFurtherData();
  for (std::size_t i = 0; i < m_families.size(); ++i)
    if (m_families[i]->isChecked()) choice.names.push_back(offered[i]);
  setChoice(choice, m_options);
}

void StudySummaryWindow::setChoice(const study::RepresentationChoice& choice, const study::StudyOptions& options) {
  m_choice = choice;
  m_options = options;
  m_model.plan(study::representationsOf(m_choice));
  refresh();
}

bool StudySummaryWindow::isRunning() const { return m_tasks.isRunning(m_key); }

void StudySummaryWindow::cancel() { m_tasks.cancel(m_key); }

std::optional<std::size_t> StudySummaryWindow::nextMaterial() const {
  for (std::size_t i = 0; i < m_failures.size(); ++i)
    if (m_failures[i].isEmpty() && !m_model.missing(i).empty()) return i;
  return std::nullopt;
}

void StudySummaryWindow::measure() {
  std::ranges::fill(m_failures, QString());
  measureNext();
}

void StudySummaryWindow::measureNext() {
  if (const auto next = nextMaterial(); next && !isRunning()) start(*next);
  refresh();
}

void StudySummaryWindow::start(std::size_t material) {
  study::StudyOptions options = m_options;
  // A row is reported as it is measured: through the tasks' thread, to a window that may be gone by then.
  options.measured = [window = QPointer(this), tasks = &m_tasks, material](const study::MeasuredRepresentation& one) {
    QMetaObject::invokeMethod(
        tasks,
        [window, material, record = one.record] {
          if (!window) return;
          window->m_model.add(material, record);
          window->refresh();
        },
        Qt::QueuedConnection);
  };
  const QString name = QString::fromStdString(m_model.materials()[material]);
  m_tasks.run<bool>(
      {tr("Measuring %1 (%2 of %3)").arg(name, QString::number(material + 1), QString::number(m_ids.size())), m_key},
      [id = m_ids[qsizetype(material)], options, missing = m_model.missing(material)](const TaskControl& control) {
        const materials::Material read = libraryMaterial(id, control);
        study::runStudy({read.tabulated(control), read.brdf}, missing, options, control);
        return !control.stop.stop_requested();
      },
      [this](bool complete) { complete ? measureNext() : refresh(); },
      [this, material](const QString& error) { fail(material, error); }, [this] { refresh(); });
}

void StudySummaryWindow::fail(std::size_t material, const QString& error) {
  m_failures[material] = error;
  measureNext();
}

QString StudySummaryWindow::csv() const {
  const RenderOptions& picture = m_options.picture;
  return m_model.csv(m_machine, study::picturesText(picture.width, picture.height, picture.samples));
}

QString StudySummaryWindow::status() const {
  std::size_t done = 0;
  QStringList lines;
  for (std::size_t i = 0; i < m_failures.size(); ++i) {
    if (!m_failures[i].isEmpty())
      lines << tr("%1 is excluded: %2")
                   .arg(QString::fromStdString(m_model.materials()[i]), m_failures[i].section('\n', 0, 0));
    else if (m_model.missing(i).empty())
      ++done;
  }
  const auto next = nextMaterial();
  QString first = tr("%1 of %2 materials are measured.").arg(done).arg(m_ids.size());
  if (isRunning() && next) first += ' ' + tr("Measuring %1.").arg(QString::fromStdString(m_model.materials()[*next]));
  lines.prepend(first);
  return lines.join('\n');
}

void StudySummaryWindow::refresh() {
  const bool running = isRunning();
  m_measure->setText(running ? tr("S&top") : m_model.isEmpty() ? tr("Meas&ure") : tr("Meas&ure the Rest"));
  m_measure->setEnabled(running || nextMaterial());
  m_measure->setToolTip(running ? tr("Stops measuring; finished results stay (Escape)")
                                : tr("Measures the missing representations in the background"));
  m_copy->setEnabled(!m_model.isEmpty());
  for (QCheckBox* box : m_families) box->setEnabled(!running);
  m_empty->setVisible(m_model.rowCount() == 0);
  m_empty->setText(tr("Choose at least one kind of representation."));
  m_status->setText(!running && m_model.isEmpty() && m_model.rowCount() > 0
                        ? tr("Measuring takes about two seconds for each of %1 representations of %2 materials.")
                              .arg(m_model.rowCount())
                              .arg(m_ids.size())
                        : status());
}

void StudySummaryWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && isRunning()) return cancel();
  QDialog::keyPressEvent(event);
}

}  // namespace gonio::app

#include "moc_study_summary_window.cpp"
