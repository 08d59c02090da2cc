// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <QStringList>

namespace gonio::app {

class DockLayout;
struct EditorParts;

/// What the window of a new editor shows at once, for pictures of it (scripts/screenshots.sh). Empty strings, zeros and
/// false change nothing.
struct PreparedView {
  QString plot;             // kind of plot
  QString compare;          // comparison mode: off, split, flicker, difference, two-up
  bool models = false;      // ranks the fits of all models
  bool factors = false;     // shows the factor curves
  QString study;            // measures the representations, and shows the one of this name
  double widen = 0;         // stretches F2 by this factor
  QString withF1Of;         // takes F1 from this file
  QStringList blended;      // shows the Interpolation dock with these materials
  std::size_t encoded = 0;  // shows the code of so many coefficients
  QString scene;            // shows the Scene dock with this scene
  QStringList otherSlots;   // fills the material slots of the scene after the first
  int acquired = 0;         // acquires the material from so many samples
  int acquisitionPage = 0;  // page of the Acquisition dock, 0 to 3
};

/// Brings an editor into this state, as soon as its material is open and what is needed has been computed.
void prepare(EditorParts& parts, DockLayout& docks, const PreparedView& view);

}  // namespace gonio::app
