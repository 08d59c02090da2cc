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

/// An error over the number of samples, with a dot for each number at which it was measured.
class ErrorCurve : public QWidget {
  Q_OBJECT

 public:
  struct Point {
    int samples;
    double value;
  };

  explicit ErrorCurve(QWidget* parent = nullptr);

  /// @param title of the values' axis, with the unit. Values that are not finite are not drawn. Points may have any
  /// order.
  void setPoints(std::vector<Point> points, const QString& title, bool logarithmic = false);
  const std::vector<Point>& points() const { return m_points; }
  /// Marks the current number of samples with a ring; 0: none.
  void setMarked(int samples);
  /// Shown in the middle while there are no points.
  void setHint(const QString& hint);
  /// Position of a point's dot, in widget pixels; empty if it is not drawn.
  std::optional<QPointF> place(int point) const;
  /// The point with the dot nearest to a position; -1 if none is close.
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
