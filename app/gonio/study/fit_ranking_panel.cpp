// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/fit_ranking_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTreeView>

#include "app/gonio/study/sheet_sources.h"
#include "widgets/inputs/plain_text_style.h"
#include "widgets/panels/sorted_table.h"
#include "widgets/parameters/formula_text.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {
const QString rankingKey = QStringLiteral("ranking");
}

FitRankingPanel::FitRankingPanel(Document& document, DocumentController& controller, BackgroundTasks& tasks,
                                 QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_controller(controller),
      m_tasks(tasks),
      m_sorted(new QSortFilterProxyModel(this)),
      m_metric(new QComboBox(this)),
      m_fitAll(new QPushButton(this)),
      m_sheet(new QPushButton(tr("Contact &Sheet..."), this)),
      m_copy(new QPushButton(tr("Copy as &CSV"), this)),
      m_view(new QTreeView(this)),
      m_empty(new QLabel(m_view)) {
  buildView();
  auto* label = new QLabel(tr("Me&tric"), this);
  label->setBuddy(m_metric);
  for (const metrics::MetricRecord& record : metrics::metricRecords()) {
    m_metric->addItem(widgets::toQString(record.name));
    m_metric->setItemData(m_metric->count() - 1, widgets::formulaHtml(record.formula), widgets::richToolTipRole);
  }
  m_metric->setToolTip(tr("Metric of the errors in the table; fits minimise the log error"));
  connect(m_metric, &QComboBox::activated, this,
          [this](int at) { m_model.setMetric(metrics::metricRecords()[std::size_t(at)].metric); });
  connect(m_fitAll, &QPushButton::clicked, this, [this] { isRunning() ? m_tasks.cancel(rankingKey) : fitAll(); });
  auto* top = new QHBoxLayout;
  top->addWidget(m_fitAll);
  top->addWidget(label);
  top->addWidget(m_metric);
  top->addStretch();
  top->addWidget(m_sheet);
  top->addWidget(m_copy);
  m_copy->setToolTip(tr("Copies the fits, with their errors in every metric, as comma-separated text"));
  connect(m_sheet, &QPushButton::clicked, this,
          [this] { Q_EMIT contactSheetRequested(sheetSource(m_document.name(), m_document.material(), m_model)); });
  connect(m_copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(m_model.csv()); });
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addLayout(top);
  layout->addWidget(m_view, 1);
  connect(&document, &Document::materialChanged, this, &FitRankingPanel::materialChanged);
  connect(&document, &Document::stateChanged, this, &FitRankingPanel::refresh);
  connect(&document, &Document::selectionChanged, this, &FitRankingPanel::refresh);
  connect(&tasks, &BackgroundTasks::changed, this, &FitRankingPanel::refresh);
  refresh();
}

void FitRankingPanel::buildView() {
  widgets::setUpSortedTable(*m_view, *m_sorted, m_model, *m_empty);
  m_view->sortByColumn(FitRankingModel::ErrorColumn, Qt::AscendingOrder);
  m_view->setAccessibleName(tr("Ranking of fits"));
  const int line = fontMetrics().height();
  m_view->setIconSize({5 * line / 2, 5 * line / 2});
  QHeaderView* header = m_view->header();
  header->setSectionResizeMode(QHeaderView::Interactive);
  header->resizeSection(FitRankingModel::NameColumn, 22 * line);
  header->resizeSection(FitRankingModel::PlotColumn, 4 * line);
  for (const int column : {FitRankingModel::ErrorColumn, FitRankingModel::SnrColumn})
    header->resizeSection(column, 9 * line);
  connect(m_view, &QTreeView::clicked, this, &FitRankingPanel::use);
  connect(m_view, &QTreeView::activated, this, &FitRankingPanel::use);
}

bool FitRankingPanel::isRunning() const { return m_tasks.isRunning(rankingKey); }

void FitRankingPanel::materialChanged() {
  m_tasks.drop(rankingKey);
  m_model.clear();
  refresh();
}

void FitRankingPanel::fitAll() {
  const LoadedMaterialPtr material = m_document.material();
  if (!material) return;
  m_model.clear();
  // A row is reported as it is done: through the tasks' thread, to a panel that may be gone by then.
  const auto showFit = [panel = QPointer(this), tasks = &m_tasks, material](const study::RankedFit& ranked) {
    QMetaObject::invokeMethod(
        tasks,
        [panel, material, ranked] {
          if (panel && panel->m_document.material() == material) panel->take(ranked);
        },
        Qt::QueuedConnection);
  };
  m_tasks.run<bool>(
      {tr("Fitting all models"), rankingKey},
      [material, showFit](const TaskControl& control) {
        study::RankingOptions options;
        options.modelDone = showFit;
        study::rankFits({material->table(control), material->material.brdf}, options, control);
        return true;
      },
      [this](bool) { refresh(); }, [this](const QString& error) { Q_EMIT failed(tr("Cannot fit all models"), error); });
  refresh();
}

void FitRankingPanel::take(const study::RankedFit& ranked) {
  if (ranked.fit.cancelled) return;
  m_document.rememberFit(ranked.fit);
  m_model.add(ranked);
  refresh();
}

void FitRankingPanel::use(const QModelIndex& index) {
  // A click on a tick is about the plots.
  if (index.isValid() && index.column() != FitRankingModel::PlotColumn)
    m_controller.chooseModel(*m_model.ranked(m_sorted->mapToSource(index).row()).fit.model);
}

void FitRankingPanel::refresh() {
  m_fitAll->setText(isRunning() ? tr("Stop") : tr("Fit &All"));
  m_fitAll->setToolTip(
      isRunning() ? tr("Stops fitting; finished fits stay")
                  : tr("Fits each of the %1 models and ranks them (Ctrl+Shift+F5)").arg(models::allModels().size()));
  m_fitAll->setEnabled(m_document.material() != nullptr);
  const auto* edit = m_document.active<editing::DifferentialEdit>();
  m_model.setCurrent(edit ? edit->model : nullptr);
  m_copy->setEnabled(m_model.rowCount() > 0);
  // A sheet of the first fits would not show the best ones.
  m_sheet->setEnabled(m_model.rowCount() > 0 && !isRunning());
  m_sheet->setToolTip(isRunning() ? tr("Available when all fits are complete; press Stop to use the finished ones")
                                  : tr("The fits as images side by side, with error maps"));
  m_empty->setVisible(m_model.rowCount() == 0);
  m_empty->setText(!m_document.material() ? tr("Open a material to rank the models by their fits.")
                   : isRunning()          ? tr("The first model is being fitted.")
                                          : tr("Press Fit All to fit each of the %1 models to this material and rank "
                                                        "them.\n"
                                                        "Click a row to use its fit; tick it to show it in the plots.")
                                       .arg(models::allModels().size()));
}

}  // namespace gonio::app

#include "moc_fit_ranking_panel.cpp"
