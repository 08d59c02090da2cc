// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/baselines/baselines.h"
#include "core/models/model.h"

namespace gonio::study {

/// Kinds of representations, in the order of display.
enum class RepresentationFamily {
  table,
  fit,
  factors,
  code,
  components,
  patches,  ///< codes of patches over a dictionary that K-SVD learned (dictionary::PatchDictionary)
  nonparametric,
  publishedNonparametric,  ///< non-parametric factors of the published table (materials/npf_file.h)
  baselines,
  published,     ///< PDV factors and codes as the papers describe them
  alternatives,  ///< codes by basis pursuit, PDV factors with terms that are fitted together
  neural
};
inline constexpr int representationFamilyCount = 12;

/// The id on the command line and in files: "table", "fits", "factors", "codes", "components", "patches",
/// "nonparametric", "published-nonparametric", "baselines", "published", "alternatives" or "neural".
std::string_view familyId(RepresentationFamily family);
/// The name for display in legends.
std::string_view familyName(RepresentationFamily family);
/// @throws Error that lists the ids.
RepresentationFamily familyById(std::string_view id);

/// All families that need only the material: all except components and patches, which need a training set, and the
/// published non-parametric factors, which need their table.
std::vector<RepresentationFamily> familiesWithoutFurtherData();

/// A representation of a material at one budget.
struct Representation {
  RepresentationFamily family = RepresentationFamily::table;
  std::string id;     ///< "table-nearest" (TableLookup::cell: the node at or below, not the nearest one),
                      ///< "table-trilinear", a model's id, "factors-2d", "factors-3d", "code", "components",
                      ///< "components-separated", "patches", "nonparametric", "published-nonparametric", a baseline's
                      ///< id, "factors-2d-published", "factors-3d-published", "code-published", "factors-2d-joint",
                      ///< "factors-3d-joint", "factors-3d-compact", "code-basis-pursuit", "neural". 2d: two factors, F1
                      ///< and F2; 3d: three factors
  std::string label;  ///< for display, e.g. "GGX", "PDV factors, three curves"
  double budget = 0;  ///< number of terms, of coefficients or components per channel, or of fitted parameters; of a
                      ///< baseline: maximum bytes; 0 if there is no budget
  std::string budgetText;  ///< e.g. "10 terms"; "" if there is no budget

  bool operator==(const Representation&) const = default;
  /// Label and budget, e.g. "PDV factors, three curves, 10 terms".
  std::string fullLabel() const;
};

/// Components of the diffuse and of the specular part (dictionary::SeparatedComponents).
inline constexpr std::string_view separatedComponentsId = "components-separated";

/// Maximum per channel: the `.code` format has a 16-bit count.
inline constexpr int maxCodeCoefficients = 65535;
/// Maximum budget of a baseline.
inline constexpr int maxBaselineBytes = 100'000'000;

/// A selection of representations to measure.
struct RepresentationChoice {
  /// Default: all of familiesWithoutFurtherData() except baselines, published, alternatives and neural.
  std::vector<RepresentationFamily> families{RepresentationFamily::table, RepresentationFamily::fit,
                                             RepresentationFamily::factors, RepresentationFamily::code,
                                             RepresentationFamily::nonparametric};
  std::vector<const models::Model*> models;               ///< empty: all registered models
  std::vector<const factorization::Baseline*> baselines;  ///< empty: all of studiedBaselines()
  /// Of PDV factors. The budgets of baselines are the sizes in bytes of PDV files of three factors with these numbers
  /// of terms.
  std::vector<int> terms{1, 2, 3, 5, 8, 10, 14, 20};
  std::vector<std::size_t> coefficients{32, 64, 128, 256, 512, 1024, 2048};  ///< per channel
  std::vector<int> components{4, 8, 16, 32, 64, 128};                        ///< per channel
  bool separatedComponents = false;  ///< whether the components also include those of separatedComponentsId
};

/// The baselines of the family: all except the non-parametric factors, which are a family of their own.
std::vector<const factorization::Baseline*> studiedBaselines();
/// One of studiedBaselines() by its id. @throws Error that lists the ids.
const factorization::Baseline& findStudiedBaseline(std::string_view id);

/// The maximum budget of a representation: terms of factors, coefficients of codes, bytes of baselines. 0 if its id
/// alone describes it.
int maxBudget(std::string_view id);
/// Whether a representation needs a budget besides its id, see maxBudget().
bool needsBudget(std::string_view id);
/// A representation by its id and budget as in the records of a study, e.g. ("factors-3d", 10). See needsBudget().
/// Components and patches are not supported. @throws Error that states what was found and what was expected.
Representation representationById(std::string_view id, std::optional<double> budget = {});

/// The selected representations, in the order of measurement and display.
std::vector<Representation> representationsOf(const RepresentationChoice& choice = {});

}  // namespace gonio::study
