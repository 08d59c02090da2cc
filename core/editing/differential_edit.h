// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <string_view>

#include "core/editing/artist_controls.h"
#include "core/math/types.h"
#include "core/models/model.h"

namespace gonio::editing {

/// How the change of a fitted model from M to M' is applied to a measurement m (all 1/sr). If M' = M, m is bitwise
/// unchanged. applyEdits() clamps the result at 0.
enum class Composition {
  additive,  ///< m + (M' - M): Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance Modeling and
             ///< Acquisition", section 4.4.1, eq. 4.40-4.41
  logPlus,   ///< (rho_0 + m)(rho_0 + M') / (rho_0 + M) - rho_0: a ratio in highlights, a difference in the tails
  lobes      ///< each lobe carries the ratio q = (m + eps) / (M + eps) along as it widens (LobeChange); only for models
             ///< that are sums of lobes (models::Model::hasLobes())
};

/// What is shown and stored of a composition.
struct CompositionRecord {
  std::string_view id;           ///< in documents, on the command line and in Python
  std::string_view name;         ///< for display, e.g. "Log-plus"
  std::string_view description;  ///< one or two sentences
  std::string_view formula;      ///< of the edited value, one per line; m, M, M' as above
  std::string_view reference;
};
/// Indexed by Composition.
inline constexpr std::array<CompositionRecord, 3> compositionRecords{
    {{"additive", "Additive", "Adds the change of the model.", "m + M' - M",
      "Tongbuasirilai 2023, Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition, eq. 4.40"},
     {"log-plus", "Log-plus", "Close to a ratio where values are large, to a difference where they are small.",
      "(1 + m) (1 + M') / (1 + M) - 1", ""},
     {"lobes", "Lobes",
      "Multiplies each edited lobe k by the ratio q of measurement to fit. The ratio moves with a highlight as it "
      "widens: it is taken at the directions w, which have the same position in the profile of the fitted lobe as the "
      "evaluated directions have in the profile of the edited lobe. The factor of the diffuse term is near 1 where "
      "this "
      "term is only a small part of the model.",
      "m + sum_k (M'_k q(w_k) - M_k q), q = (m + 0.001) / (M + 0.001)\n"
      "diffuse term: 1 + (M_k / M)^4 (q - 1) instead of q",
      ""}}};
inline constexpr auto compositionIds = [] {
  std::array<std::string_view, compositionRecords.size()> ids;
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = compositionRecords[i].id;
  return ids;
}();

/// rho_0 of Composition::logPlus, 1/sr.
inline constexpr double logPlusOffset = 1;

/// The difference that Composition::logPlus adds to a value, 1/sr. @param value m. @param edited M'. @param fitted M.
inline Rgb logPlusChange(const Rgb& value, const Rgb& edited, const Rgb& fitted) {
  return (logPlusOffset + glm::max(value, Rgb(0))) * ((edited - fitted) / (logPlusOffset + fitted));
}

/// A differential edit: applies the change of a fitted model to the measurement,
///   edited = max(0, measured + strength change(measured, model(edited), model(fitted))),
/// so that detail that the model does not explain is preserved. Composition defines the three changes. The published
/// one is additive (Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition",
/// section 4.4.1, eq. 4.40-4.41): its change is model(edited) - model(fitted), which the paper calls the
/// residual, here with its sign; eq. 4.40 as printed has the absolute value.
struct DifferentialEdit {
  const models::Model* model = nullptr;
  models::ParameterValues fitted;
  models::ParameterValues edited;
  Composition composition = Composition::additive;
  /// Values of artistControls(): applied to the parameters `edited` (target()), or to the edited BRDF values
  /// (colours()).
  models::ParameterValues controls = models::defaultParameters(artistControls());
  /// Whether highlights keep their directional albedo as their width changes, and peaks that the fit does not explain
  /// widen with them; only for Composition::lobes (LobeChange). Off in documents of versions up to 0.2.0.
  bool keepsAlbedo = false;

  /// The parameters of the edited model: `edited` with the controls applied.
  models::ParameterValues target() const { return withControls(model->spec(), edited, controls); }
  /// The same with the widths of the fit.
  models::ParameterValues targetWithFittedWidths() const {
    return withWidthsOf(fitted, model->spec(), edited, controls);
  }
  /// The matrix C of the controls, applied to edited values v after the change of the model: v' = max(0, v + strength
  /// (C v - v)).
  glm::dmat3 colours() const { return colourMatrix(controls); }
  bool changesModel() const { return target() != fitted; }
  bool changesColours() const { return colours() != glm::dmat3(1); }
  bool isIdentity() const { return !changesModel() && !changesColours(); }
  bool operator==(const DifferentialEdit&) const = default;
};

/// Lobes if the model is a sum of lobes: the most accurate in tests with a known result (docs/results/compositions.md).
/// Otherwise additive, as published.
inline Composition defaultComposition(const models::Model& model) {
  return model.hasLobes() ? Composition::lobes : Composition::additive;
}

/// An edit that changes nothing yet, with the default options.
inline DifferentialEdit unchangedEdit(const models::Model& model, const models::ParameterValues& fitted) {
  return {.model = &model,
          .fitted = fitted,
          .edited = fitted,
          .composition = defaultComposition(model),
          .keepsAlbedo = true};
}

}  // namespace gonio::editing
