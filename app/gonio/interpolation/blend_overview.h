// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QStackedWidget>
#include <QWidget>

#include "app/gonio/interpolation/blend_spaces.h"

class QLabel;
class QPushButton;
namespace gonio::widgets {
struct BlendCorner;
class BlendPad;
class NumberField;
class ParameterSlider;
class BlendStrip;
}  // namespace gonio::widgets

namespace gonio::app {

/// Editor for the position between the materials: a slider and a number for two, a pad for more.
class BlendPositionEditor : public QStackedWidget {
  Q_OBJECT

 public:
  explicit BlendPositionEditor(QWidget* parent = nullptr);

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

/// All interpolation spaces, as rows of small spheres.
class BlendOverview : public QWidget {
  Q_OBJECT

 public:
  explicit BlendOverview(const BlendSpaces& spaces);

  widgets::BlendStrip& strip() const { return *m_strip; }
  /// Shows the spaces after BlendSpaces::setMaterials().
  void showSpaces();

 Q_SIGNALS:
  /// The user chose the sphere of a space at t, or its name (t < 0).
  void chosen(gonio::interpolation::InterpolationSpace space, double t);
  /// The user wants cancelled spaces to be computed after all.
  void drawRequested();

 private:
  void showSpace(BlendSpaces::Space space);

  const BlendSpaces& m_spaces;
  widgets::BlendStrip* m_strip;
  QPushButton* m_draw;
};

}  // namespace gonio::app
