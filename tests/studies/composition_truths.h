// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/editing/artist_controls.h"

namespace gonio {

/// One control of an edit, and where the search for its best value begins.
struct ControlSearch {
  editing::ArtistControl control;
  Rgb start{1};
  double steps = 4;  ///< a power of 2 is cut into so many
  int reach = 4;     ///< steps to either side; 0: the start is taken
  /// Widens only the upper of two highlights, by its own parameters, in place of the control of all.
  bool upperOnly = false;
};

/// A material, the same after an edit that is known, and the controls that are to reproduce it.
struct EditTruth {
  std::string kind;  ///< "roughness", "coat", "upper lobe", "pair" ...
  std::string name;
  std::shared_ptr<const TabulatedBrdf> before, after;
  std::vector<ControlSearch> search;
  /// Changes colours of a model's parameters by their roles; null where the controls alone are searched.
  std::function<void(const models::ModelSpec&, models::ParameterValues&)> recolour = {};
};

/// Materials of models that are no editing model (GGX, layered lobes), their own parameters changed; and pairs of
/// near-measured materials that differ mostly in finish. @param grid of the tables.
std::vector<EditTruth> editTruths(const HalfDifferenceGrid& grid);

}  // namespace gonio
