// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/study_view.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QSortFilterProxyModel>
#include <QToolTip>
#include <QTreeView>
#include <algorithm>

#include "widgets/inputs/plain_text_style.h"
#include "widgets/panels/sorted_table.h"
#include "widgets/study/study_scatter.h"

namespace gonio::app {

StudyView::StudyView(StudyModel& model)
    : QSplitter(Qt::Horizontal),
      m_model(model),
      m_sorted(new QSortFilterProxyModel(this)),
      m_scatter(new widgets::StudyScatter),
      m_table(new QTreeView),
      m_empty(new QLabel(m_table)) {
  addWidget(m_scatter);
  addWidget(m_table);
  setChildrenCollapsible(false);
  const int half = 50 * fontMetrics().height();
  setSizes({half, half});
  buildTable();
  connectParts();
}

void StudyView::buildTable() {
  widgets::setUpSortedTable(*m_table, *m_sorted, m_model, *m_empty);
  m_table->sortByColumn(StudyModel::SnrColumn, Qt::AscendingOrder);
  m_table->setAccessibleName(tr("Representations and their cost"));
  m_table->installEventFilter(this);
  const int line = fontMetrics().height();
  m_table->setIconSize({2 * line, 2 * line});
  QHeaderView* header = m_table->header();
  header->resizeSection(StudyModel::NameColumn, 18 * line);
  for (int column = StudyModel::SnrColumn; column < StudyModel::ColumnCount; ++column)
    header->resizeSection(
        column, std::max(header->sectionSizeHint(column), (column == StudyModel::EvaluationColumn ? 9 : 6) * line));
}

void StudyView::connectParts() {
  connect(m_table, &QTreeView::clicked, this, &StudyView::chooseIndex);
  connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& current) { m_scatter->setCurrent(pointOf(m_sorted->mapToSource(current).row())); });
  connect(m_scatter, &widgets::StudyScatter::currentChanged, this,
          [this](int point) { m_table->setCurrentIndex(m_sorted->mapFromSource(m_model.index(rowOf(point), 0))); });
  connect(m_scatter, &widgets::StudyScatter::chosen, this, [this](int point) { Q_EMIT chosen(rowOf(point)); });
  connect(m_scatter, &widgets::StudyScatter::dismissed, this, &StudyView::dismissed);
  connect(m_scatter, &widgets::StudyScatter::hovered, this, [this](int point, const QPoint& at) {
    if (point < 0)
      QToolTip::hideText();
    else
      widgets::showRichToolTip(at, m_model.toolTip(rowOf(point)), m_scatter);
  });
}

int StudyView::rowOf(int point) const { return point < 0 ? -1 : m_model.measuredRows()[std::size_t(point)]; }

int StudyView::pointOf(int row) const {
  const auto rows = m_model.measuredRows();
  const auto found = std::ranges::find(rows, row);
  return found == rows.end() ? -1 : int(found - rows.begin());
}

void StudyView::chooseIndex(const QModelIndex& index) {
  if (index.isValid()) Q_EMIT chosen(m_sorted->mapToSource(index).row());
}

bool StudyView::eventFilter(QObject* watched, QEvent* event) {
  if (watched != m_table || event->type() != QEvent::KeyPress) return QSplitter::eventFilter(watched, event);
  switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
      chooseIndex(m_table->currentIndex());
      return true;
    case Qt::Key_Escape:
      if (!m_model.hasShown()) return false;
      Q_EMIT dismissed();
      return true;
    default:
      return false;
  }
}

void StudyView::showPoints(const study::StudyAxes& axes) { m_scatter->setRecords(m_model.records(), axes); }

void StudyView::setMarks(int shown, int best) {
  m_model.setMarks(shown, best);
  m_scatter->setMarks(pointOf(shown), pointOf(best));
}

void StudyView::setHint(const QString& text) {
  m_scatter->setHint(text);
  m_empty->setVisible(m_model.rowCount() == 0);
  m_empty->setText(text);
}

}  // namespace gonio::app

#include "moc_study_view.cpp"
