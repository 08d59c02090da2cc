// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QStackedWidget>

class QLabel;

namespace gonio::widgets {
struct BlendCorner;
class BlendPad;
class NumberField;
class ParameterSlider;
}  // namespace gonio::widgets

namespace gonio::app {

/// Editor for the position between the materials: a slider and a number for two, a pad for more.
class BlendPositionEditor : public QStackedWidget {
  Q_OBJECT

 public:
  explicit BlendPositionEditor(QWidget* parent = nullptr);

  widgets::ParameterSlider& slider() const { return *m_slider; }
  widgets::NumberField& number() const { return *m_number; }
  widgets::BlendPad& pad() const { return *m_pad; }
  /// @param corners one per material.
  void setCorners(std::vector<widgets::BlendCorner> corners);
  void setPosition(const QPointF& position);
  /// Sets a text beside the slider.
  void setExplanation(const QString& text);

 Q_SIGNALS:
  void positionEdited(const QPointF& position);

 private:
  QWidget* buildLine();

  widgets::ParameterSlider* m_slider;
  widgets::NumberField* m_number;
  QLabel* m_explanation;
  widgets::BlendPad* m_pad;
};

}  // namespace gonio::app
