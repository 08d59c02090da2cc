// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>

#include "core/models/model.h"

namespace gonio::test {

/// The defaults of a model with its first parameters replaced.
inline models::ParameterValues leadingParameters(const models::Model& model, const std::vector<Rgb>& first) {
  models::ParameterValues values = models::defaultParameters(model.spec());
  std::copy(first.begin(), first.end(), values.values.begin());
  return values;
}

}  // namespace gonio::test
