// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/models/model.h"

namespace gonio::editing {

/// A differential edit (Tongbuasirilai 2023, section 4.4.1, eq. 4.40-4.41, the sign of the residual kept): the change
/// of a fitted model is added to the measurement,
///   edited = max(0, measured + strength (model(edited) - model(fitted))),
/// so that what the model does not explain survives.
struct DifferentialEdit {
  const models::Model* model = nullptr;
  models::ParameterValues fitted;
  models::ParameterValues edited;

  /// Whether the edited model is the fitted one.
  bool isIdentity() const { return edited == fitted; }
  bool operator==(const DifferentialEdit&) const = default;
};

}  // namespace gonio::editing
