// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/study/study_plot.h"

class QCustomPlot;
class QLabel;

namespace gonio::widgets {

struct PlotStyle;

/// The records of a study as points over a cost, with the Pareto front as steps. The pointer and the arrow keys move
/// between points; a click or Space chooses one, a double click or Enter activates it. Points, lines
/// and front are those of the exported plot (study::studyGeometry()).
class StudyScatter : public QWidget {
  Q_OBJECT

 public:
  explicit StudyScatter(QWidget* parent = nullptr);

  void setRecords(std::vector<study::StudyRecord> records, const study::StudyAxes& axes);
  const std::vector<study::StudyRecord>& records() const { return m_records; }
  /// Marks points with a ring and a word; -1: none.
  void setMarks(int shown, int best);
  /// The point at which the keys are; -1: none.
  void setCurrent(int record);
  int current() const { return m_current; }
  /// Text shown in the middle if there are no points, or if none has values on both axes.
  void setHint(const QString& hint);
  /// Position of a point in the widget, pixels; nullopt if its values cannot be shown on the axes.
  std::optional<QPointF> place(int record) const;

 Q_SIGNALS:
  /// A click, or Space.
  void chosen(int record);
  /// A double click, or Enter.
  void activated(int record);
  void currentChanged(int record);
  /// The pointer is on a point, or on none (-1).
  void hovered(int record, const QPoint& globalPosition);
  /// Escape was pressed.
  void dismissed();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 private:
  void refresh();
  void addSeries(const PlotStyle& style);
  void addFront(const PlotStyle& style);
  void addMark(int record, const QString& word, const QPen& pen, double size, bool square);
  void addAxes(const PlotStyle& style);
  std::optional<QPointF> fraction(int record) const;
  int nearest(const QPointF& position) const;
  void step(int by);

  QCustomPlot* m_chart;
  QLabel* m_hint;
  std::vector<study::StudyRecord> m_records;
  study::StudyAxes m_axes;
  study::StudyGeometry m_geometry;
  int m_shown = -1, m_best = -1, m_current = -1;
};

}  // namespace gonio::widgets
