// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QPointF>
#include <QWidget>
#include <optional>

#include "widgets/curves/curve_view.h"

namespace gonio::widgets {

/// A smooth curve a colour channel that the hand pulls by control points lying on it. With all channels linked one set
/// of points moves the three curves in proportion; else the points are those of one channel. Mouse: a drag moves the
/// selected points, a drag beside them selects with a box, a double-click adds a point. Keyboard: Tab goes from point
/// to point, the arrows move the selected ones (Shift: a tenth), Delete takes them away, Ctrl+A selects all, Escape
/// takes a drag back, else selects none. The value of the current point is shown and announced, that of the place under
/// the pointer shown.
class CurveEditor : public QWidget {
  Q_OBJECT

 public:
  static constexpr int allChannels = -1;

  explicit CurveEditor(QWidget* parent = nullptr);

  void setAxis(const CurveAxis& axis);
  const CurveAxis& axis() const { return m_view.axis; }
  /// @param ghost what the curves were before any edit; drawn faintly. The control points stay where the same nodes
  /// are shown with curves of this widget's own making, else they are chosen anew.
  void setCurves(const std::vector<double>& nodes, const ChannelCurves& curves, const ChannelCurves& ghost);
  void clear();
  const std::vector<double>& nodes() const { return m_nodes; }
  const ChannelCurves& curves() const { return m_curves; }
  /// What is shown and edited: a channel, or allChannels.
  void setChannel(int channel);
  int channel() const { return m_channel; }
  void setLogarithmic(bool logarithmic);
  /// Vertical lines with names; what lies beyond `reach` is greyed out.
  void setLimits(const std::vector<CurveLimit>& limits, double reach = 1e300);
  const std::vector<CurveLimit>& limits() const { return m_view.limits; }
  /// Shown instead of the curves while there are none.
  void setHint(const QString& hint);

  /// Places of the control points, increasing, and which of them are selected.
  const std::vector<double>& points() const { return m_points; }
  const std::vector<bool>& selected() const { return m_selected; }
  /// Where a place of the axis is on the widget, in pixels.
  double toX(double place) const { return m_view.toX(place); }
  /// Where a point is on the widget.
  QPointF pointPosition(std::size_t point) const;

  QSize sizeHint() const override;

 Q_SIGNALS:
  /// Everything between these two is one step of the user's hand.
  void interactionStarted();
  void interactionEnded();
  void curvesEdited(const gonio::widgets::ChannelCurves& curves);
  /// The current point in words.
  void announced(const QString& text);
  /// The place of the current point, or that under the pointer, in units of the nodes.
  void pointedAt(double place);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  bool focusNextPrevChild(bool next) override;

 private:
  void choosePoints();
  void layOut();
  std::vector<double> shownCurve(const ChannelCurves& curves) const;
  double valueAt(double place) const;
  int pointAt(const QPointF& position) const;
  void select(int point, bool extend);
  /// Moves the selected points by pixels from where they were when the drag began.
  void dragBy(const QPointF& pixels);
  void beginDrag();
  void cancelDrag();
  void hover(const QPointF& position);
  QString valuesAt(double place) const;
  void drawCurves(QPainter& painter, const PlotStyle& style) const;
  void drawPoints(QPainter& painter, const PlotStyle& style) const;
  void removeSelected();
  void edited();
  void announce();

  CurveView m_view;
  std::vector<double> m_nodes;
  ChannelCurves m_curves, m_ghost;
  std::vector<double> m_points;
  std::vector<bool> m_selected;
  int m_channel = allChannels, m_current = -1;
  bool m_dragging = false, m_boxing = false;
  std::vector<bool> m_selectedBefore;  ///< the box, which adds to it
  std::optional<double> m_hovered;
  QPointF m_pressed, m_boxEnd;
  ChannelCurves m_curvesBefore;
  std::vector<double> m_pointsBefore;
  QString m_hint, m_announced;
};

}  // namespace gonio::widgets
