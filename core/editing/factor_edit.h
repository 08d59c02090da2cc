// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <string>

#include "core/factorization/pdv_factors.h"
#include "core/support/json_object.h"

namespace gonio::editing {

/// An edit of the PDV factor curves of a material (Tongbuasirilai et al. 2017 and 2019; Tongbuasirilai 2023,
/// "Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition", eq. 4.25). With preserveDetail, the change
/// of the factor model is added to the measurement,
///   edited = max(0, measured + strength (pdv(edited) - pdv(original))),
/// so that detail that the factors do not explain is preserved. Without it, the model replaces the measurement:
///   edited = (1 - strength) measured + strength pdv(edited).
/// Copies share the curves, which are immutable.
struct FactorEdit {
  using Curves = std::shared_ptr<const factorization::PdvFactors>;

  Curves original;  ///< factors of the measurement, before the edit
  Curves edited;
  bool preserveDetail = true;

  /// Whether the edit leaves every base bitwise unchanged.
  bool isIdentity() const { return preserveDetail && sameCurves(original, edited); }
  bool operator==(const FactorEdit& other) const {
    return sameCurves(original, other.original) && sameCurves(edited, other.edited) &&
           preserveDetail == other.preserveDetail;
  }
  /// Whether the curves are equal; compares the numbers only if the objects differ.
  static bool sameCurves(const Curves& a, const Curves& b) { return a == b || (a && b && *a == *b); }
};

/// Memory of the curves in bytes; 0 for null.
std::size_t bytesOf(const FactorEdit::Curves& curves);

/// {"type": "factors", "original": F, "edited": F, "keepDetail": true}, where F is
///   {"form": "2d", "transform": "log-plus", "highest": y, "thetaNodes": [..], "deviationNodes": [..],
///    "phiNodes": [..], "channels": [[{"f1": [..], "f2": [..], "f3": [..]}, one per term], one per channel]}.
/// "lowest" (PdvFactors::lowest) is present only if it is negative. "form" is "2d" (two factors, F1 and F2) or "3d"
/// (three factors, F1, F2 and F3). Both sets of curves are stored (about ten kB per term), so that a document does not
/// depend on how later versions factorise the measurement.
/// @throws Error if a set of curves is missing or contains a number that is not finite.
nlohmann::json toJson(const FactorEdit& edit);
/// @param where the object's path in its document, for errors, e.g. "edits[0]". @throws Error that states the key, what
/// was found and what was expected.
FactorEdit factorEditFromJson(const nlohmann::json& json, const std::string& where);

/// Transfers an edit of factor curves to another material with the curves `target`:
/// - F1: the ratio at each angle, term by term, so that "10 % stronger" remains 10 % stronger;
/// - F2: the curve of the target is stretched by the ratio of the half-width after the edit to that before it, term by
///   term; the rest of the change is added to the first term, as a function of |Dp| in units of the half-width;
/// - F3: the difference, for the first term.
/// Terms that the edit removed are removed. If `target` equals edit.original, returns the edit itself. preserveDetail
/// is copied. @throws Error if form or transform differ, or either side has no curves.
FactorEdit transferredEdit(const FactorEdit& edit, const FactorEdit::Curves& target);

}  // namespace gonio::editing
