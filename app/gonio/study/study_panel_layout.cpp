// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Where the parts of the panel stand, and what they set off.
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QToolTip>
#include <QTreeView>
#include <algorithm>

#include "app/gonio/study/study_panel.h"
#include "widgets/panels/sorted_table.h"
#include "widgets/parameters/parameter_text.h"
#include "widgets/study/study_scatter.h"

namespace gonio::app {

void StudyPanel::buildControls() {
  m_quality->addItem(tr("rendered SNR"));
  for (const metrics::MetricRecord& record : metrics::metricRecords()) {
    m_quality->addItem(widgets::fromView(record.name));
    m_quality->setItemData(m_quality->count() - 1, widgets::fromView(record.formula), Qt::ToolTipRole);
  }
  m_quality->setToolTip(tr("What the plot shows upward, and which error the table has"));
  for (const study::Cost cost : study::allCosts) m_cost->addItem(QString::fromStdString(study::axisTitle(cost)));
  m_cost->setToolTip(tr("What the plot shows to the right"));
  m_copy->setToolTip(tr("Copies all that is measured, with every error, as comma-separated text"));
  m_export->setToolTip(tr("The plot as it is chosen, dark on white"));
  m_back->setToolTip(tr("The preview shows the material again (Escape)"));
  m_measure->setToolTip(tr("Measures every representation in the background: those that are missing, or all anew"));
  auto* top = new QHBoxLayout;
  top->addWidget(m_measure);
  const auto labelled = [&](const QString& text, QComboBox* box) {
    auto* label = new QLabel(text);
    label->setBuddy(box);
    top->addWidget(label);
    top->addWidget(box);
  };
  labelled(tr("E&rror by"), m_quality);
  labelled(tr("o&ver"), m_cost);
  top->addStretch();
  for (QPushButton* button : {m_back, m_copy, m_export}) top->addWidget(button);
  auto* splitter = new QSplitter(Qt::Horizontal);
  splitter->addWidget(m_scatter);
  splitter->addWidget(m_view);
  splitter->setChildrenCollapsible(false);
  const int half = 50 * fontMetrics().height();
  splitter->setSizes({half, half});
  m_footer->setForegroundRole(QPalette::PlaceholderText);
  m_footer->setTextFormat(Qt::PlainText);
  m_footer->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_footer->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addLayout(top);
  layout->addWidget(splitter, 1);
  layout->addWidget(m_budget);
  layout->addWidget(m_footer);
}

void StudyPanel::buildView() {
  widgets::setUpSortedTable(*m_view, *m_sorted, m_model, *m_empty);
  m_view->sortByColumn(StudyModel::SnrColumn, Qt::AscendingOrder);
  m_view->setAccessibleName(tr("Representations and what they cost"));
  m_view->installEventFilter(this);
  const int line = fontMetrics().height();
  m_view->setIconSize({2 * line, 2 * line});
  QHeaderView* header = m_view->header();
  header->resizeSection(StudyModel::NameColumn, 18 * line);
  for (int column = StudyModel::SnrColumn; column < StudyModel::ColumnCount; ++column)
    header->resizeSection(column, (column == StudyModel::EvaluationColumn ? 9 : 6) * line);
}

void StudyPanel::connectParts() {
  connect(m_measure, &QPushButton::clicked, this,
          [this] { isRunning() ? m_tasks.cancel(QStringLiteral("study")) : measure(); });
  connect(m_back, &QPushButton::clicked, this, [this] { show(-1); });
  connect(m_copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(csv()); });
  connect(m_export, &QPushButton::clicked, this, &StudyPanel::exportSvg);
  connect(m_cost, &QComboBox::currentIndexChanged, this, &StudyPanel::refreshPlot);
  connect(m_quality, &QComboBox::currentIndexChanged, this, [this] {
    if (const auto metric = axes().quality) m_model.setMetric(*metric);
    refreshPlot();
  });
  connect(m_view, &QTreeView::clicked, this, &StudyPanel::clicked);
  const auto rowOf = [this](int point) { return point < 0 ? -1 : m_model.measuredRows()[std::size_t(point)]; };
  const auto select = [this, rowOf](int point) {
    m_view->setCurrentIndex(m_sorted->mapFromSource(m_model.index(rowOf(point), 0)));
  };
  connect(m_scatter, &widgets::StudyScatter::currentChanged, this, select);
  connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& current) {
    const auto rows = m_model.measuredRows();
    const auto found = std::ranges::find(rows, m_sorted->mapToSource(current).row());
    m_scatter->setCurrent(found == rows.end() ? -1 : int(found - rows.begin()));
  });
  connect(m_scatter, &widgets::StudyScatter::chosen, this, [this, rowOf](int point) { show(rowOf(point)); });
  connect(m_scatter, &widgets::StudyScatter::dismissed, this, [this] { show(-1); });
  connect(m_scatter, &widgets::StudyScatter::hovered, this, [this, rowOf](int point, const QPoint& at) {
    if (point < 0)
      QToolTip::hideText();
    else
      QToolTip::showText(at, m_model.toolTip(rowOf(point)), m_scatter);
  });
  connect(m_budget, &StudyBudgetBar::budgetChanged, this, &StudyPanel::refresh);
  connect(m_budget, &StudyBudgetBar::taken, this, [this] {
    if (m_best < 0) return;
    const study::Representation representation = m_model.representation(m_best);
    if (m_shown != m_best) show(m_best);
    Q_EMIT taken(representation);
  });
  connect(&m_document, &Document::materialChanged, this, &StudyPanel::materialChanged);
  connect(&m_tasks, &BackgroundTasks::changed, this, [this] {
    if (const QString text = m_measure->text(); isRunning() != (text == tr("Stop"))) refresh();
  });
}

}  // namespace gonio::app
