// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QLabel>
#include <QToolButton>
#include <QWidget>
#include <utility>

#include "core/models/parameter_spec.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"

class QHBoxLayout;

namespace gonio::widgets {

/// Minimum and maximum of a parameter's slider: the soft range. If the fitted value is outside, the range is extended
/// beyond this value, but not beyond the hard range.
std::pair<double, double> sliderRange(const models::ParameterSpec& spec, double fitted);

/// One number of a parameter in a row of aligned columns: label, slider, number field, space for a swatch, reset arrow.
/// Double-click on the label or slider, or Backspace on the slider, requests a reset.
class ParameterLine : public QWidget {
  Q_OBJECT

 public:
  ParameterLine(const models::ParameterSpec& spec, const QString& label, QWidget* parent = nullptr);

  /// @param reference the fitted value; the slider's range includes it.
  void setValue(double value, double reference);
  /// Shows a bold label and the reset arrow; by default if value and reference differ.
  void setModified(bool modified);
  bool isModified() const { return m_modified; }
  /// Puts a widget before the label (a disclosure arrow) or after the number (a swatch).
  void setLeading(QWidget* widget);
  void setTrailing(QWidget* widget);
  /// Replaces slider and number by a widget (a list of choices).
  void replaceNumber(QWidget* widget);
  /// Updates the display after a change of the program's units.
  void showUnit();
  void setDescription(const QString& toolTip, const QString& accessibleName);

  ParameterSlider* slider() const { return m_slider; }
  NumberField* field() const { return m_field; }
  QLabel* label() const { return m_label; }

 Q_SIGNALS:
  void editingStarted();
  void valueEdited(double value);
  void editingFinished();
  void resetRequested();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  models::ParameterSpec m_spec;
  QHBoxLayout* m_layout;
  QLabel* m_label;
  ParameterSlider* m_slider;
  NumberField* m_field;
  QWidget* m_leading;
  QWidget* m_trailing;
  QToolButton* m_reset;
  bool m_modified = false;
};

}  // namespace gonio::widgets
