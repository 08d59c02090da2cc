// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

class QCustomPlot;
class QLabel;

namespace gonio::widgets {

struct PlotStyle;

/// A measure of error over the number of samples, one dot a measured count: none stands for what was not measured.
class ErrorCurve : public QWidget {
  Q_OBJECT

 public:
  struct Point {
    int samples;
    double value;
  };

  explicit ErrorCurve(QWidget* parent = nullptr);

  /// @param title of the values' axis with the unit. Values that are no finite number have no place. At any order.
  void setPoints(std::vector<Point> points, const QString& title, bool logarithmic = false);
  const std::vector<Point>& points() const { return m_points; }
  /// The count that is in use has a ring; 0: none.
  void setMarked(int samples);
  /// Shown in the middle while there are no points.
  void setHint(const QString& hint);
  /// The dot of a point in the widget's pixels; nothing where it has no place.
  std::optional<QPointF> place(int point) const;
  /// The point with the dot nearest to a place, -1 where none is within reach.
  int pointAt(const QPointF& place) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void refresh();
  void addAxes(const PlotStyle& style);
  void addPoints(const PlotStyle& style);

  QCustomPlot* m_chart;
  QLabel* m_hint;
  std::vector<Point> m_points;
  QString m_title;
  bool m_logarithmic = false;
  int m_marked = 0;
};

}  // namespace gonio::widgets
