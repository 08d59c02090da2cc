// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QLineEdit>

namespace gonio::widgets {

/// A field for one number: hard range, unit suffix, simple arithmetic, four significant digits. Enter or leaving the
/// field commits, Esc restores, arrow keys step (Shift a tenth). A text that was not changed never changes the value,
/// however many digits it hides. The wheel acts only while the field has the focus.
class NumberField : public QLineEdit {
  Q_OBJECT

 public:
  explicit NumberField(QWidget* parent = nullptr);

  void setRange(double hardMin, double hardMax);
  /// What is shown and typed is displayFactor * value^displayPower: 180/pi for angles, a power of 1/2 for square roots.
  void setUnit(const QString& unit, double displayFactor = 1, double displayPower = 1);
  void setStep(double step) { m_step = step; }
  double value() const { return m_value; }
  /// Shows a value; emits nothing.
  void setValue(double value);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 Q_SIGNALS:
  /// The user gave a new value, inside the hard range.
  void valueEdited(double value);
  /// What was typed lay outside the hard range: `used` is the limit that was taken instead.
  void clamped(double typed, double used);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;

 private:
  QString formatted(double value) const;
  void commit();
  void restore();
  void stepBy(double steps);
  void offer(double value);

  double m_value = 0, m_min = 0, m_max = 1, m_step = 0.01, m_displayFactor = 1, m_displayPower = 1;
  QString m_unit;
  QString m_shown;  ///< the text as it was set; equal text means nothing was typed
};

/// Four significant digits with the point of the C locale, no trailing zeros: "0.3", "1.25e-05".
QString formatNumber(double value);
/// An angle in degrees with its unit: "45.5°".
QString degreesText(double radians);

}  // namespace gonio::widgets
