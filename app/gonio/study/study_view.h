// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QSplitter>

#include "app/gonio/study/study_model.h"
#include "core/study/study_plot.h"

class QLabel;
class QSortFilterProxyModel;
class QTreeView;

namespace gonio::widgets {
class StudyScatter;
}

namespace gonio::app {

/// The rows of a study as points over a cost and as a table; the current row is the same in both.
class StudyView : public QSplitter {
  Q_OBJECT

 public:
  explicit StudyView(StudyModel& model);

  QTreeView& table() const { return *m_table; }
  widgets::StudyScatter& scatter() const { return *m_scatter; }
  /// To be called again after the rows of the model changed.
  void showPoints(const study::StudyAxes& axes);
  /// Marks the row shown in the preview and the best row within the budget; -1: none.
  void setMarks(int shown, int best);
  /// Sets a text shown in place of the points, and in place of the rows if the model is empty.
  void setHint(const QString& text);

 Q_SIGNALS:
  void chosen(int row);
  /// Escape was pressed.
  void dismissed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void buildTable();
  void connectParts();
  int rowOf(int point) const;
  int pointOf(int row) const;
  void chooseIndex(const QModelIndex& index);

  StudyModel& m_model;
  QSortFilterProxyModel* m_sorted;
  widgets::StudyScatter* m_scatter;
  QTreeView* m_table;
  QLabel* m_empty;
};

}  // namespace gonio::app
