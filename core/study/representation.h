// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/models/model.h"

namespace gonio::study {

/// Kinds of representations, in the order in which they are listed.
enum class RepresentationFamily { table, fit, factors, code, components, nonparametric };
inline constexpr int representationFamilyCount = 6;

/// "table", "fits", "factors", "codes", "components", "nonparametric": on the command line and in files.
std::string_view familyId(RepresentationFamily family);
/// For people, in legends.
std::string_view familyName(RepresentationFamily family);
/// @throws Error that lists the ids.
RepresentationFamily familyById(std::string_view id);

/// One way to keep a material, at one budget. A value.
struct Representation {
  RepresentationFamily family = RepresentationFamily::table;
  std::string id;     ///< "table-nearest", "table-trilinear", a model's id, "factors-2d", "factors-3d", "code",
                      ///< "components", "nonparametric"
  std::string label;  ///< for people: "GGX", "PDV factors, three curves"
  double budget = 0;  ///< terms, coefficients or components per channel; fitted numbers; 0 where nothing is counted
  std::string budgetText;  ///< "10 terms", or "" where nothing is counted

  bool operator==(const Representation&) const = default;
  /// Label with its budget: "PDV factors, three curves, 10 terms".
  std::string fullLabel() const;
};

/// Per channel: the `.code` file counts them in 16 bits.
inline constexpr int maxCodeCoefficients = 65535;

/// Which representations there are to measure.
struct RepresentationChoice {
  /// Components are left out by default: their basis is learned, not shipped.
  std::vector<RepresentationFamily> families{RepresentationFamily::table, RepresentationFamily::fit,
                                             RepresentationFamily::factors, RepresentationFamily::code,
                                             RepresentationFamily::nonparametric};
  std::vector<const models::Model*> models;  ///< none: all registered ones
  std::vector<int> terms{1, 2, 3, 5, 8, 10, 14, 20};
  std::vector<std::size_t> coefficients{32, 64, 128, 256, 512, 1024, 2048};  ///< a channel
  std::vector<int> components{4, 8, 16, 32, 64, 128};                        ///< a channel
};

/// Whether one is described by its id and a budget, not by its id alone: terms of factors, coefficients of codes.
bool needsBudget(std::string_view id);
/// One by its id and budget, as a record of a study names it: ("factors-3d", 10); a fit and what counts nothing need no
/// budget. Components, whose basis is learned, are left out.
/// @throws Error stating what was found and what was expected.
Representation representationById(std::string_view id, std::optional<double> budget = {});

/// All of them, in the order in which a study measures and lists them.
std::vector<Representation> representationsOf(const RepresentationChoice& choice = {});

}  // namespace gonio::study
