// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <string>

#include "core/factorization/pdv_factors.h"
#include "core/support/json_object.h"

namespace gonio::editing {

/// An edit of the PDV factor curves of a material (Tongbuasirilai et al. 2017 and 2019; Tongbuasirilai 2023, eq. 4.25).
/// With the measured detail kept, the change of the factor model is added to the measurement,
///   edited = max(0, measured + strength (pdv(edited) - pdv(original))),
/// so that what the factors do not explain survives; without it the model takes the measurement's place,
///   edited = (1 - strength) measured + strength pdv(edited).
/// The curves are shared between copies and never change.
struct FactorEdit {
  using Curves = std::shared_ptr<const factorization::PdvFactors>;

  Curves original;  ///< of the measurement, as the factorisation gave them
  Curves edited;
  bool keepDetail = true;

  /// Whether it leaves every base as it is, bit for bit.
  bool isIdentity() const { return keepDetail && sameCurves(original, edited); }
  bool operator==(const FactorEdit& other) const {
    return sameCurves(original, other.original) && sameCurves(edited, other.edited) && keepDetail == other.keepDetail;
  }
  /// Compares the numbers only where the owners differ.
  static bool sameCurves(const Curves& a, const Curves& b) { return a == b || (a && b && *a == *b); }
};

/// Memory of curves; 0 of none.
std::size_t bytesOf(const FactorEdit::Curves& curves);

/// {"type": "factors", "original": F, "edited": F, "keepDetail": true}, where F is
///   {"form": "2d", "transform": "log-plus", "highest": y, "thetaNodes": [..], "deviationNodes": [..],
///    "phiNodes": [..], "channels": [[{"f1": [..], "f2": [..], "f3": [..]}, one per term], one per channel]}.
/// Both sets of curves are stored: some ten kB a term, and a document looks the same whatever a later version's
/// factorisation would make of the measurement.
/// @throws Error when a set of curves is missing or holds a number that is not finite.
nlohmann::json toJson(const FactorEdit& edit);
/// @throws Error that states the key, what was found and what was expected.
FactorEdit factorEditFromJson(const nlohmann::json& json, const std::string& where);

}  // namespace gonio::editing
