// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <vector>

class QCustomPlot;
class QLabel;

namespace gonio::widgets {

struct PlotStyle;

/// The uncertainty of a reconstruction over the half angle: the median of its standard deviations, in a band from low
/// to high ones.
class UncertaintyCurve : public QWidget {
  Q_OBJECT

 public:
  struct Point {
    double thetaH;             ///< degrees
    double low, median, high;  ///< standard deviations of the mapped value
  };

  explicit UncertaintyCurve(QWidget* parent = nullptr);

  /// @param points in ascending order of the angle.
  void setPoints(std::vector<Point> points);
  const std::vector<Point>& points() const { return m_points; }
  /// Shown in the middle while there are no points.
  void setHint(const QString& hint);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void refresh();
  void addBand(const PlotStyle& style);

  QCustomPlot* m_chart;
  QLabel* m_hint;
  std::vector<Point> m_points;
};

}  // namespace gonio::widgets
