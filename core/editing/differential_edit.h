// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/editing/artist_controls.h"
#include "core/editing/composition.h"
#include "core/models/model.h"

namespace gonio::editing {

/// A differential edit: the change of a fitted model is brought to the measurement,
///   edited = max(0, measured + strength change(measured, model(edited), model(fitted))),
/// so that what the model does not explain survives. Composition has the three changes; the published one
/// (Tongbuasirilai 2023, section 4.4.1, eq. 4.40-4.41, the sign of the residual kept) is additive.
struct DifferentialEdit {
  const models::Model* model = nullptr;
  models::ParameterValues fitted;
  models::ParameterValues edited;
  Composition composition = Composition::additive;
  /// artistControls(), applied to `edited`, or to the values that come of it (colours()).
  models::ParameterValues controls = models::defaultParameters(artistControls());

  /// The parameters of the edited model: `edited` with the controls applied.
  models::ParameterValues target() const { return withControls(model->spec(), edited, controls); }
  /// Applied to the edited values, after the change of the model: v' = max(0, v + strength (C v - v)).
  glm::dmat3 colours() const { return colourMatrix(controls); }
  bool changesModel() const { return target() != fitted; }
  bool changesColours() const { return colours() != glm::dmat3(1); }
  bool isIdentity() const { return !changesModel() && !changesColours(); }
  bool operator==(const DifferentialEdit&) const = default;
};

/// By lobes where the model is a sum of them: nearest to edits whose truth is known (docs/results/compositions.md).
/// Else additive, as published.
inline Composition defaultComposition(const models::Model& model) {
  return model.hasLobes() ? Composition::lobes : Composition::additive;
}

}  // namespace gonio::editing
