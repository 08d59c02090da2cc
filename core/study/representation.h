// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/models/model.h"

namespace gonio::study {

/// Kinds of representations, in the order of lists.
enum class RepresentationFamily { table, fit, factors, code, components, nonparametric };
inline constexpr int representationFamilyCount = 6;

/// The id on the command line and in files: "table", "fits", "factors", "codes", "components" or "nonparametric".
std::string_view familyId(RepresentationFamily family);
/// The name for display in legends.
std::string_view familyName(RepresentationFamily family);
/// @throws Error that lists the ids.
RepresentationFamily familyById(std::string_view id);

/// A representation of a material at one budget.
struct Representation {
  RepresentationFamily family = RepresentationFamily::table;
  std::string id;     ///< "table-nearest", "table-trilinear", a model's id, "factors-2d", "factors-3d", "code",
                      ///< "components", "nonparametric"
  std::string label;  ///< for display, e.g. "GGX", "PDV factors, three curves"
  double budget = 0;  ///< number of terms, of coefficients or components per channel, or of fitted parameters; 0 if
                      ///< there is no budget
  std::string budgetText;  ///< e.g. "10 terms"; "" if there is no budget

  bool operator==(const Representation&) const = default;
  /// Label and budget, e.g. "PDV factors, three curves, 10 terms".
  std::string fullLabel() const;
};

/// Maximum per channel: the `.code` format has a 16-bit count.
inline constexpr int maxCodeCoefficients = 65535;

/// A selection of representations to measure.
struct RepresentationChoice {
  /// Default: all except components, which require a trained basis.
  std::vector<RepresentationFamily> families{RepresentationFamily::table, RepresentationFamily::fit,
                                             RepresentationFamily::factors, RepresentationFamily::code,
                                             RepresentationFamily::nonparametric};
  std::vector<const models::Model*> models;  ///< empty: all registered models
  std::vector<int> terms{1, 2, 3, 5, 8, 10, 14, 20};
  std::vector<std::size_t> coefficients{32, 64, 128, 256, 512, 1024, 2048};  ///< per channel
  std::vector<int> components{4, 8, 16, 32, 64, 128};                        ///< per channel
};

/// Whether a representation needs a budget besides its id: the terms of factors, the coefficients of codes.
bool needsBudget(std::string_view id);
/// A representation by its id and budget as in the records of a study, e.g. ("factors-3d", 10). See needsBudget().
/// Components are not supported. @throws Error that states what was found and what was expected.
Representation representationById(std::string_view id, std::optional<double> budget = {});

/// The selected representations, in the order of studies and lists.
std::vector<Representation> representationsOf(const RepresentationChoice& choice = {});

}  // namespace gonio::study
