// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/interpolation/blend_spaces.h"

class QPushButton;

namespace gonio::widgets {
class BlendStrip;
}

namespace gonio::app {

/// All interpolation spaces, as rows of small spheres.
class BlendOverview : public QWidget {
  Q_OBJECT

 public:
  explicit BlendOverview(const BlendSpaces& spaces);

  widgets::BlendStrip& strip() const { return *m_strip; }
  QPushButton& drawButton() const { return *m_draw; }
  /// Shows the spaces after BlendSpaces::setMaterials().
  void showSpaces();

 Q_SIGNALS:
  /// The user chose the sphere of a space at t, or its name (t < 0).
  void chosen(gonio::editing::InterpolationSpace space, double t);
  /// The user wants cancelled spaces to be computed after all.
  void drawRequested();

 private:
  void showSpace(BlendSpaces::Space space);

  const BlendSpaces& m_spaces;
  widgets::BlendStrip* m_strip;
  QPushButton* m_draw;
};

}  // namespace gonio::app
