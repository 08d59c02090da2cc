// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/study_window.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QScreen>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QTabWidget>
#include <QToolTip>
#include <QTreeView>
#include <algorithm>

#include "widgets/inputs/dialogs.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/inputs/plain_text_style.h"
#include "widgets/panels/sorted_table.h"
#include "widgets/parameters/formula_text.h"
#include "widgets/parameters/parameter_text.h"
#include "widgets/study/study_scatter.h"

namespace gonio::app {

namespace {

const QString showKey = QStringLiteral("study preview"), plotPurpose = QStringLiteral("plot");
const QString namesKey = QStringLiteral("study/representations"), timesKey = QStringLiteral("study/times"),
              sizeKey = QStringLiteral("study/size");

void addMetrics(QComboBox& box) {
  for (const metrics::MetricRecord& record : metrics::metricRecords()) {
    box.addItem(widgets::toQString(record.name));
    box.setItemData(box.count() - 1, widgets::formulaHtml(record.formula), widgets::richToolTipRole);
  }
}

}  // namespace

StudyWindow::StudyWindow(Document& document, BackgroundTasks& tasks, QWidget* parent)
    : QDialog(parent, Qt::Window),
      m_document(document),
      m_tasks(tasks),
      m_openRun(new StudyRun(StudyRun::Subject::openMaterial, document, tasks, this)),
      m_libraryRun(new StudyRun(StudyRun::Subject::library, document, tasks, this)),
      m_run(m_openRun),
      m_sorted(new QSortFilterProxyModel(this)),
      m_pages(new QTabWidget),
      m_choice(new StudyChoice),
      m_table(new QTreeView),
      m_scatter(new widgets::StudyScatter),
      m_sheet(new StudySheet(tasks)),
      m_budget(new StudyBudgetBar),
      m_empty(new QLabel(m_table)),
      m_status(new QLabel),
      m_footer(new QLabel) {
  const int em = fontMetrics().height();
  resize(QSize(em * 100, em * 46).boundedTo(screen()->availableSize()));
  m_pages->addTab(buildResults(), tr("&Results"));
  m_pages->addTab(buildChart(), tr("C&hart"));
  m_pages->addTab(m_sheet, tr("&Sheet"));
  auto* middle = new QSplitter(Qt::Horizontal);
  middle->setChildrenCollapsible(false);
  auto* top = buildTop();
  middle->addWidget(m_choice);
  middle->addWidget(m_pages);
  middle->setStretchFactor(1, 1);
  middle->setSizes({20 * em, 68 * em});
  for (QLabel* label : {m_status, m_footer}) {
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  }
  m_status->setWordWrap(true);
  m_footer->setForegroundRole(QPalette::PlaceholderText);
  m_footer->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(top);
  layout->addWidget(middle, 1);
  layout->addWidget(m_budget);
  layout->addWidget(m_status);
  layout->addWidget(m_footer);
  for (QPushButton* button : findChildren<QPushButton*>()) button->setAutoDefault(false);
  connectParts();
  m_choice->setNames(study::defaultFamilies());
  showRun(*m_openRun);
}

QWidget* StudyWindow::buildTop() {
  m_measure = new QPushButton;
  m_times = new QCheckBox(tr("&Times"));
  m_times->setChecked(true);
  m_times->setToolTip(
      tr("Also measures the times of an evaluation and of a frame, which takes about two seconds for each "
         "representation"));
  m_subjects = new QComboBox;
  m_subjects->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  m_subjects->setToolTip(
      tr("What is compared: the open material, or materials selected in the Library panel (their "
         "menu has Measure Representations)"));
  m_subjects->addItem(tr("Open material"));
  m_back = new QPushButton(tr("&Back to the Material"));
  m_back->setToolTip(tr("Shows the material in the preview again (Escape)"));
  auto* top = new QWidget;
  auto* layout = new QHBoxLayout(top);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(labelFor(tr("&Material"), m_subjects));
  layout->addWidget(m_subjects);
  layout->addWidget(m_measure);
  layout->addWidget(m_times);
  layout->addStretch();
  layout->addWidget(m_back);
  return top;
}

QWidget* StudyWindow::buildResults() {
  const int line = fontMetrics().height();
  m_metric = new QComboBox;
  addMetrics(*m_metric);
  m_metric->setToolTip(tr("Metric of the errors in the table; fits minimise the log error"));
  m_copy = new QPushButton(tr("Copy as &CSV"));
  m_copy->setToolTip(tr("Copies all measured values, with the errors in every metric, as comma-separated text"));
  widgets::setUpSortedTable(*m_table, *m_sorted, m_openRun->model(), *m_empty);
  m_table->sortByColumn(StudyModel::SnrColumn, Qt::AscendingOrder);
  m_empty->setAutoFillBackground(true);
  m_empty->setBackgroundRole(QPalette::Base);
  m_empty->parentWidget()->layout()->setContentsMargins(0, 0, 0, 0);
  m_table->setAccessibleName(tr("Representations and their cost"));
  m_table->setIconSize({2 * line, 2 * line});
  m_table->installEventFilter(this);
  QHeaderView* header = m_table->header();
  header->setStretchLastSection(false);
  const int widths[StudyModel::ColumnCount] = {17, 3, 5, 7, 7, 9, 5, 7, 5, 5, 6, 5, 8};
  for (int column = 0; column < StudyModel::ColumnCount; ++column)
    header->resizeSection(column, std::max(header->sectionSizeHint(column), widths[column] * line));
  auto* page = new QWidget;
  auto* layout = new QVBoxLayout(page);
  auto* top = new QHBoxLayout;
  top->addWidget(labelFor(tr("&Error"), m_metric));
  top->addWidget(m_metric);
  top->addStretch();
  top->addWidget(m_copy);
  layout->addLayout(top);
  layout->addWidget(m_table, 1);
  return page;
}

QWidget* StudyWindow::buildChart() {
  m_quality = new QComboBox;
  m_quality->addItem(tr("rendered SNR"));
  addMetrics(*m_quality);
  m_quality->setToolTip(tr("Accuracy on the vertical axis"));
  m_cost = new QComboBox;
  for (const study::Cost cost : study::allCosts) m_cost->addItem(QString::fromStdString(study::axisTitle(cost)));
  m_cost->setToolTip(tr("Cost on the horizontal axis"));
  m_export = new QPushButton(tr("E&xport as SVG..."));
  m_export->setToolTip(tr("Saves the chart as shown, on a white background"));
  auto* page = new QWidget;
  auto* layout = new QVBoxLayout(page);
  auto* top = new QHBoxLayout;
  top->addWidget(labelFor(tr("&Accuracy"), m_quality));
  top->addWidget(m_quality);
  top->addWidget(labelFor(tr("&vs."), m_cost));
  top->addWidget(m_cost);
  top->addStretch();
  top->addWidget(m_export);
  layout->addLayout(top);
  layout->addWidget(m_scatter, 1);
  return page;
}

void StudyWindow::connectParts() {
  connect(m_measure, &QPushButton::clicked, this,
          [this] { m_run->isRunning() ? m_run->cancel() : m_run->measure({.timed = m_times->isChecked()}); });
  connect(m_back, &QPushButton::clicked, this, [this] { show(-1); });
  connect(m_copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(m_run->csv(rows())); });
  connect(m_export, &QPushButton::clicked, this, &StudyWindow::exportSvg);
  connect(m_budget, &StudyBudgetBar::useRequested, this, [this] { use(m_best); });
  connect(m_budget, &StudyBudgetBar::budgetChanged, this, &StudyWindow::refresh);
  connect(m_times, &QCheckBox::toggled, this, &StudyWindow::refresh);
  connect(m_subjects, &QComboBox::activated, this,
          [this](int index) { showRun(index == 0 ? *m_openRun : *m_libraryRun); });
  connect(m_choice, &StudyChoice::namesChanged, this, &StudyWindow::applyChoice);
  connect(m_metric, &QComboBox::currentIndexChanged, this, [this](int index) {
    for (StudyRun* run : {m_openRun, m_libraryRun})
      run->model().setMetric(metrics::metricRecords()[std::size_t(index)].metric);
  });
  connect(m_quality, &QComboBox::currentIndexChanged, this, [this](int index) {
    if (index > 0) m_metric->setCurrentIndex(index - 1);
    refreshResults();
  });
  connect(m_cost, &QComboBox::currentIndexChanged, this, &StudyWindow::refreshResults);
  connect(m_pages, &QTabWidget::currentChanged, this, &StudyWindow::refreshSheet);
  connect(m_sorted, &QAbstractItemModel::layoutChanged, this, &StudyWindow::refreshResults);
  connect(m_table, &QTreeView::clicked, this, [this](const QModelIndex& index) {
    if (index.column() != StudyModel::PlotColumn)
      show(m_sorted->mapToSource(index).row());  // a tick is about the plots
  });
  connect(m_table, &QTreeView::doubleClicked, this,
          [this](const QModelIndex& index) { use(m_sorted->mapToSource(index).row()); });
  connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& current) { m_scatter->setCurrent(pointOf(m_sorted->mapToSource(current).row())); });
  connect(m_scatter, &widgets::StudyScatter::currentChanged, this, [this](int point) {
    m_table->setCurrentIndex(m_sorted->mapFromSource(m_run->model().index(rowOf(point), 0)));
  });
  connect(m_scatter, &widgets::StudyScatter::chosen, this, [this](int point) { show(rowOf(point)); });
  connect(m_scatter, &widgets::StudyScatter::activated, this, [this](int point) { use(rowOf(point)); });
  connect(m_scatter, &widgets::StudyScatter::dismissed, this, [this] { show(-1); });
  connect(m_scatter, &widgets::StudyScatter::hovered, this, [this](int point, const QPoint& at) {
    if (point < 0)
      QToolTip::hideText();
    else
      widgets::showRichToolTip(at, m_run->model().toolTip(rowOf(point)), m_scatter);
  });
  connect(m_sheet, &StudySheet::compareRequested, this, &StudyWindow::compareRequested);
  connect(m_sheet, &StudySheet::saveRequested, this, &StudyWindow::saveRequested);
  connect(m_sheet, &StudySheet::writeRequested, this, &StudyWindow::writeRequested);
  connect(m_sheet, &StudySheet::failed, this, &StudyWindow::failed);
  for (StudyRun* run : {m_openRun, m_libraryRun}) connectRun(*run);
  // What is edited is what the user wants to see.
  connect(&m_document, &Document::stateChanged, this, [this] { show(-1); });
  connect(&m_document, &Document::editChanged, this, [this] {
    if (m_subject || m_wanted >= 0) return show(-1);
    showModelInUse();  // all else stays at a step of a slider
  });
  for (const auto signal : {&Document::stateChanged, &Document::selectionChanged})
    connect(&m_document, signal, this, &StudyWindow::refresh);
}

void StudyWindow::connectRun(StudyRun& run) {
  connect(&run, &StudyRun::restarted, this, [this, &run] {
    if (&run == m_openRun) show(-1);
    if (&run == m_run) refreshResults();
  });
  connect(&run, &StudyRun::rowMeasured, this, [this, &run] {
    if (&run == m_run) refreshResults();
  });
  connect(&run, &StudyRun::runningChanged, this, [this, &run] {
    if (&run == m_run && !run.isRunning()) sortRows();  // also rows that kept their places under the pointer
    refresh();
    refreshSheet();
  });
  connect(&run, &StudyRun::failed, this, &StudyWindow::failed);
}

void StudyWindow::showRun(StudyRun& run) {
  m_run = &run;
  m_subjects->setCurrentIndex(&run == m_openRun ? 0 : 1);
  m_sorted->setSourceModel(&run.model());
  sortRows();
  showColumns();
  refreshResults();
}

void StudyWindow::sortRows() {
  m_sorted->sort(m_table->header()->sortIndicatorSection(), m_table->header()->sortIndicatorOrder());
}

void StudyWindow::showColumns() {
  for (int column = 0; column < StudyModel::ColumnCount; ++column)
    m_table->setColumnHidden(column, !m_run->model().isShown(column));
}

void StudyWindow::applyChoice() {
  for (StudyRun* run : {m_openRun, m_libraryRun}) {
    study::RepresentationChoice choice = run->choice();
    choice.names = m_choice->names();
    run->setChoice(choice);
  }
}

void StudyWindow::restoreState(const QSettings& settings) {
  if (settings.contains(namesKey)) {
    std::vector<std::string> names;
    for (const QString& name : settings.value(namesKey).toStringList()) names.push_back(name.toStdString());
    m_choice->setNames(names);
  }
  m_times->setChecked(settings.value(timesKey, true).toBool());
  if (const QSize size = settings.value(sizeKey).toSize(); size.isValid())
    resize(size.boundedTo(screen()->availableSize()));
}

void StudyWindow::saveState(QSettings& settings) const {
  QStringList list;
  for (const std::string& name : m_choice->names()) list << QString::fromStdString(name);
  settings.setValue(namesKey, list);
  settings.setValue(timesKey, m_times->isChecked());
  settings.setValue(sizeKey, size());
}

void StudyWindow::present(Page page) {
  m_pages->setCurrentIndex(page);
  QDialog::show();
  raise();
  activateWindow();
}

void StudyWindow::measureOpen() {
  showRun(*m_openRun);
  if (!m_openRun->isRunning()) m_openRun->measure({.timed = m_times->isChecked()});
}

void StudyWindow::fitAll() {
  std::vector<std::string> ticked = m_choice->names();
  if (!std::ranges::count(ticked, "fits")) {
    ticked.emplace_back("fits");
    m_choice->setNames(ticked);
  }
  showRun(*m_openRun);
  m_openRun->measure({.timed = false, .family = "fits"});
}

void StudyWindow::setMaterials(const QStringList& ids) {
  m_libraryRun->setMaterials(ids);
  if (m_subjects->count() < 2) m_subjects->addItem({});
  m_subjects->setItemText(
      1, ids.size() == 1 ? tr("1 material of the library") : tr("%1 materials of the library").arg(ids.size()));
  showRun(*m_libraryRun);
}

std::vector<int> StudyWindow::rows() const {
  std::vector<int> rows;
  for (int i = 0; i < m_sorted->rowCount(); ++i)
    if (const int row = m_sorted->mapToSource(m_sorted->index(i, 0)).row(); m_run->model().isMeasured(row))
      rows.push_back(row);
  return rows;
}

int StudyWindow::rowOf(int point) const {
  return point < 0 || point >= int(m_points.size()) ? -1 : m_points[std::size_t(point)];
}

int StudyWindow::pointOf(int row) const {
  const auto found = std::ranges::find(m_points, row);
  return found == m_points.end() ? -1 : int(found - m_points.begin());
}

/// Only of the open material.
bool StudyWindow::canShow(int row) const {
  const StudyModel& model = m_run->model();
  return m_run == m_openRun && row >= 0 && row < model.rowCount() && model.studied(row) && !model.isOutdated();
}

void StudyWindow::show(int row) {
  m_tasks.drop(showKey);
  m_wanted = !canShow(row) || row == m_shown || row == m_wanted ? -1 : row;
  if (m_wanted < 0) {
    const bool was = m_subject.has_value();
    m_subject.reset();
    m_shown = -1;
    refresh();
    if (was) Q_EMIT subjectChanged();
    return;
  }
  const StudyModel::Studied studied = m_run->model().studied(row);
  m_tasks.run<widgets::PreviewSubject>(
      {tr("Preparing %1").arg(QString::fromStdString(studied->record.representation.shortLabel())), showKey},
      [studied](const TaskControl& control) { return studiedSubject(*studied, control); },
      [this, row](const widgets::PreviewSubject& subject) { adopt(row, subject); },
      [this](const QString& error) {
        m_wanted = -1;
        Q_EMIT failed(tr("Cannot show the representation"), error);
      },
      [this] { m_wanted = -1; });
  refresh();
}

void StudyWindow::adopt(int row, const widgets::PreviewSubject& subject) {
  m_wanted = -1;
  m_shown = row;
  m_subject = subject;
  refresh();
  Q_EMIT subjectChanged();
}

QString StudyWindow::shownName() const {
  return m_shown < 0 ? QString() : QString::fromStdString(model().representation(m_shown).shortLabel());
}

void StudyWindow::use(int row) {
  if (!canShow(row)) return;
  const study::Representation representation = m_run->model().representation(row);
  if (representation.kind->use == study::RepresentationUse::showInPreview && m_shown != row && m_wanted != row)
    show(row);
  Q_EMIT useRequested(representation);
}

study::StudyAxes StudyWindow::axes() const {
  study::StudyAxes axes{.cost = study::allCosts[m_cost->currentIndex()], .quality = {}};
  if (const int metric = m_quality->currentIndex() - 1; metric >= 0)
    axes.quality = metrics::metricRecords()[std::size_t(metric)].metric;
  return axes;
}

void StudyWindow::exportSvg() {
  const QString name = QString(m_run->title() + tr(" accuracy.svg")).replace('/', '-');
  const QString proposed = widgets::inDialogFolder(plotPurpose, name);
  widgets::askForPath(this, tr("Export Chart"), proposed, tr("SVG file (*.svg)"), [this](const QString& path) {
    widgets::rememberDialogFolder(plotPurpose, path);
    try {
      m_run->writeSvg(path, axes(), rows());
      Q_EMIT exported(path);
    } catch (const Error& error) {
      Q_EMIT failed(tr("Cannot export the chart"), QString::fromUtf8(error.what()));
    }
  });
}

/// The order or the results changed.
void StudyWindow::refreshResults() {
  m_points = rows();
  m_scatter->setRecords(m_run->model().records(m_points), axes());
  showColumns();
  refresh();
  refreshSheet();
}

void StudyWindow::refreshSheet() {
  const StudyModel& model = m_run->model();
  const bool isOpen = m_run == m_openRun;
  const std::size_t count = m_points.empty() ? 0 : isOpen ? 1 : std::size_t(m_run->ids().size());
  std::vector<SheetSource> sources;
  for (std::size_t i = 0; i < count && count <= StudyModel::maxKeptMaterials; ++i) {
    SheetSource source;
    source.name = isOpen ? m_run->title() : QString::fromStdString(model.materials()[i]);
    if (isOpen) source.material = m_run->material();
    if (!isOpen) source.id = m_run->ids()[qsizetype(i)];
    for (const int row : m_points) source.entries.push_back(model.studied(row, i));
    const bool isMeasured = std::ranges::any_of(source.entries, [](const SheetEntry& one) { return one != nullptr; });
    if (isMeasured) sources.push_back(std::move(source));
  }
  m_sheet->setSources(std::move(sources));
  // Rendering would disturb the times, and a sheet of the first results would not show the best.
  m_sheet->pictures().setRendering(isVisible() && m_pages->currentIndex() == SheetPage && !m_run->isRunning());
  m_sheet->setHint(count <= StudyModel::maxKeptMaterials
                       ? hint()
                       : tr("A sheet shows at most %1 materials. Select fewer in the library,\nor read the medians in "
                            "Results and Chart.")
                             .arg(StudyModel::maxKeptMaterials));
}

QString StudyWindow::hint() const {
  if (m_run == m_openRun && !m_document.material())
    return tr("Open a material to compare accuracy and cost of its representations.");
  if (m_run->isRunning()) return tr("The first representation is being measured.");
  if (m_run->model().rowCount() == 0) return tr("Tick at least one representation in the list on the left.");
  const int count = m_run->model().rowCount() * int(m_run->model().materials().size());
  const int seconds = count * (m_times->isChecked() ? 2 : 1), minute = 60;
  const QString time = seconds < minute ? tr("less than a minute") : tr("about %1 min").arg(seconds / minute);
  return tr("Press Measure to compare the %1 ticked representations in the background (%2).\n"
            "Click a result to see it in the preview, double-click it to use it.")
      .arg(m_run->model().rowCount())
      .arg(time);
}

void StudyWindow::refresh() {
  const bool running = m_run->isRunning(), timed = m_times->isChecked();
  const StudyModel& model = m_run->model();
  const bool whole = !model.isEmpty() && m_run->isComplete(timed);
  m_measure->setText(running           ? tr("S&top")
                     : whole           ? tr("Meas&ure Again")
                     : model.isEmpty() ? tr("Meas&ure")
                                       : tr("Meas&ure the Rest"));
  if (model.isOutdated() && !running) m_measure->setText(tr("Meas&ure"));
  m_measure->setToolTip(running ? tr("Stops measuring; finished results stay (Escape)")
                                : tr("Measures the representations without results in the background, or all of them "
                                     "again"));
  m_measure->setEnabled(running || m_run->canMeasure());
  m_choice->setEnabled(!running);
  m_times->setEnabled(!running);
  m_back->setVisible(m_subject.has_value());
  const QString name = m_run == m_openRun ? m_document.name() : m_subjects->itemText(1);
  m_subjects->setItemText(0,
                          m_document.material() ? tr("Open material: %1").arg(m_document.name()) : tr("Open material"));
  setWindowTitle(tr("Study: %1").arg(widgets::titleText(name)));
  showModelInUse();
  refreshBudget();
  const int shown = m_run == m_openRun ? m_shown : -1;
  m_run->model().setMarks(shown, m_best);
  m_scatter->setMarks(pointOf(shown), pointOf(m_best));
  m_scatter->setHint(m_points.empty() ? hint()
                                      : tr("No times were measured.\nTick Times and press Measure the Rest, or select "
                                           "the size as the cost."));
  m_empty->setVisible(model.rowCount() == 0 || (model.isEmpty() && !running));
  m_empty->setText(hint());
  m_status->setText(m_run->status());
  m_status->setVisible(!m_status->text().isEmpty());
  QStringList facts;
  for (const std::string& line : m_run->machine()) facts << QString::fromStdString(line);
  m_footer->setText(facts.join(QStringLiteral(" · ")));
  m_footer->setToolTip(facts.join('\n'));
  m_footer->setVisible(!facts.isEmpty());
}

void StudyWindow::showModelInUse() {
  const auto* edit = m_document.active<editing::DifferentialEdit>();
  m_openRun->model().setModelInUse(edit ? edit->model : nullptr);
}

void StudyWindow::refreshBudget() {
  const bool any = !m_points.empty();
  for (QPushButton* button : {m_copy, m_export}) button->setEnabled(any);
  const auto best = study::bestWithin(m_run->model().records(m_points), m_budget->budget());
  m_best = best && !m_run->model().isOutdated() ? m_points[*best] : -1;
  const QString name =
      m_best < 0 ? QString() : QString::fromStdString(m_run->model().representation(m_best).shortLabel());
  m_budget->setEnabled(any);
  m_budget->setResult(!any || m_run->model().isOutdated() ? QString()
                      : best                              ? tr("Best: %1").arg(name)
                             : tr("None of the %1 measured representations meets this budget.").arg(m_points.size()),
                      canShow(m_best));
}

void StudyWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) return QDialog::keyPressEvent(event);
  if (m_subject || m_wanted >= 0) return show(-1);
  if (m_run->isRunning()) return m_run->cancel();
  QDialog::keyPressEvent(event);
}

bool StudyWindow::eventFilter(QObject* watched, QEvent* event) {
  if (watched != m_table || event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
  const QModelIndex current = m_table->currentIndex();
  const int row = current.isValid() ? m_sorted->mapToSource(current).row() : -1;
  switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      use(row);
      return true;
    case Qt::Key_Space:
      if (current.column() == StudyModel::PlotColumn) return false;
      show(row);
      return true;
    case Qt::Key_Escape:
      keyPressEvent(static_cast<QKeyEvent*>(event));
      return true;
    default:
      return false;
  }
}

void StudyWindow::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  refreshSheet();
}

void StudyWindow::hideEvent(QHideEvent* event) {
  QDialog::hideEvent(event);
  refreshSheet();
}

}  // namespace gonio::app

#include "moc_study_window.cpp"
