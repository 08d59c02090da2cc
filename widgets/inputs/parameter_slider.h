// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QAbstractSlider>
#include <optional>

#include "core/models/parameter_spec.h"

namespace gonio::widgets {

/// A slider over the soft range of a parameter, with the scale of its spec (models::ParameterScale). A small tick marks
/// the reference (fitted) value. Shift moves by a tenth, Ctrl snaps; the wheel only works if the slider has the focus;
/// double-click or Backspace requests a reset. A drag, a held key or a turn of the wheel is one interaction between
/// editingStarted() and editingFinished().
class ParameterSlider : public QAbstractSlider {
  Q_OBJECT

 public:
  explicit ParameterSlider(QWidget* parent = nullptr);

  void setRange(double softMin, double softMax, models::ParameterScale scale);
  /// Shows a value, also one outside the soft range (drawn at the end); emits nothing.
  void setNumber(double value);
  double number() const { return m_number; }
  void setReference(std::optional<double> value);
  void setModified(bool modified);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void editingStarted();
  void numberEdited(double value);
  void editingFinished();
  void resetRequested();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool event(QEvent* event) override;

 private:
  double fractionOf(double value) const;
  double valueAt(double fraction) const;
  double snapped(double fraction) const;
  QRectF groove() const;
  int handleRadius() const;
  void begin();
  void end();
  void editTo(double fraction, bool snap);
  void syncAccessibleValue();

  double m_min = 0, m_max = 1, m_number = 0;
  models::ParameterScale m_scale = models::ParameterScale::linear;
  std::optional<double> m_reference;
  bool m_modified = false, m_dragging = false, m_editing = false, m_hovered = false;
  double m_dragFraction = 0;  ///< position of the drag, unlike the value neither snapped nor clamped
  double m_lastX = 0;
  class QTimer* m_wheelPause;
};

}  // namespace gonio::widgets
