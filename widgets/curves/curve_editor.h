// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QPointF>
#include <QWidget>
#include <optional>

#include "widgets/curves/curve_view.h"

namespace gonio::widgets {

/// An editor for one smooth curve per colour channel with control points on the curves. If the channels are linked, one
/// set of points scales all three curves; otherwise the points belong to one channel. Mouse: a drag on a point moves
/// the selected points, elsewhere it selects with a box; a double-click adds a point. Keyboard: Tab moves to the next
/// point, the arrows move the selected points (Shift: a tenth), Delete removes them, Ctrl+A selects all, Escape reverts
/// a drag or clears the selection. The value of the current point is shown and announced to screen readers; the value
/// under the pointer is only shown.
class CurveEditor : public QWidget {
  Q_OBJECT

 public:
  static constexpr int allChannels = -1;

  explicit CurveEditor(QWidget* parent = nullptr);

  void setAxis(const CurveAxis& axis);
  const CurveAxis& axis() const { return m_view.axis; }
  /// @param ghost the curves before any edit, drawn faintly. Control points stay if the nodes are equal and the
  /// curves come from this widget's own edits; otherwise they are chosen anew.
  void setCurves(const std::vector<double>& nodes, const ChannelCurves& curves, const ChannelCurves& ghost);
  void clear();
  const std::vector<double>& nodes() const { return m_nodes; }
  const ChannelCurves& curves() const { return m_curves; }
  /// Sets the channel to show and edit, or allChannels.
  void setChannel(int channel);
  int channel() const { return m_channel; }
  void setLogarithmic(bool logarithmic);
  /// Vertical lines with names. The axis beyond `reach` is greyed out.
  void setLimits(const std::vector<CurveLimit>& limits, double reach = 1e300);
  const std::vector<CurveLimit>& limits() const { return m_view.limits; }
  /// Shown instead of the curves while there are none.
  void setHint(const QString& hint);

  /// Ascending positions of the control points, and which of them are selected.
  const std::vector<double>& points() const { return m_points; }
  const std::vector<bool>& selected() const { return m_selected; }
  /// The x coordinate of a position on the axis, in widget pixels.
  double toX(double place) const { return m_view.toX(place); }
  /// Position of a control point on the widget.
  QPointF pointPosition(std::size_t point) const;

  QSize sizeHint() const override;

 Q_SIGNALS:
  /// Changes between these two signals are one interaction (one undo step).
  void interactionStarted();
  void interactionEnded();
  void curvesEdited(const gonio::widgets::ChannelCurves& curves);
  /// Text about the current point, for screen readers.
  void announced(const QString& text);
  /// Position of the current point or of the pointer, in units of the nodes.
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
  /// Moves the selected points by pixels, relative to the start of the drag.
  void dragBy(const QPointF& pixels);
  /// The part of a horizontal move that keeps the selected points between their neighbours.
  double reachableDistance(double pixels) const;
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
  std::vector<bool> m_selectedBefore;  ///< the selection before the box selection, which adds to it
  std::optional<double> m_hovered;
  QPointF m_pressed, m_boxEnd;
  ChannelCurves m_curvesBefore;
  std::vector<double> m_pointsBefore;
  QString m_hint, m_announced;
};

}  // namespace gonio::widgets
