// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QLineEdit>
#include <QString>
#include <optional>

namespace gonio::widgets {

/// The value of a typed number or of simple arithmetic: + - * / ^, parentheses, the constant pi, and decimal points or
/// commas ("0,3*2" is 0.6). A trailing `unit` is ignored. Empty for other texts and for results that are not finite.
std::optional<double> evaluateArithmetic(const QString& text, const QString& unit = {});

/// A field for one number: hard range, unit suffix, simple arithmetic, four significant digits. Enter or leaving the
/// field commits, Esc restores, arrow keys step (Shift a tenth). Text that the user did not change preserves the exact
/// value, including digits that are not shown. The wheel only works if the field has the focus.
class NumberField : public QLineEdit {
  Q_OBJECT

 public:
  explicit NumberField(QWidget* parent = nullptr);

  void setRange(double hardMin, double hardMax);
  /// The displayed number is displayFactor * value^displayPower, e.g. the factor 180/pi for angles or the power 1/2 for
  /// square roots.
  void setUnit(const QString& unit, double displayFactor = 1, double displayPower = 1);
  void setStep(double step) { m_step = step; }
  double value() const { return m_value; }
  /// Shows a value; emits nothing.
  void setValue(double value);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 Q_SIGNALS:
  /// The user entered a new value, inside the hard range.
  void valueEdited(double value);
  /// The entered number was outside the hard range; `used` is the limit that replaced it.
  void clamped(double typed, double used);

 protected:
  /// Whether a key is a letter where a number begins, so not meant for the field.
  bool isStrayLetter(const QKeyEvent& event) const;
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
  QString m_shown;  ///< the text as set by the program; equal text means that the user changed nothing
};

/// Four significant digits with the point of the C locale, no trailing zeros: "0.3", "1.25e-05".
QString formatNumber(double value);
/// An angle in degrees with its unit: "45.5°".
QString degreesText(double radians);

}  // namespace gonio::widgets
