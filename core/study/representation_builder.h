// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>

#include "core/dictionary/encode.h"
#include "core/dictionary/principal_components.h"
#include "core/factorization/pdv_factors.h"
#include "core/fitting/fit_data.h"
#include "core/materials/dictionary_file.h"
#include "core/study/representation.h"

namespace gonio::study {

/// What representations are of: a table, and the reflectance that pictures are compared with: the table itself, or the
/// material that it samples.
struct StudySubject {
  std::shared_ptr<const TabulatedBrdf> table;
  std::shared_ptr<const Brdf> reference;
};

/// What representations are made by.
struct BuildOptions {
  fitting::FitOptions fit;
  std::shared_ptr<const materials::NamedEnsemble> dictionary;              ///< null: the bundled one
  std::shared_ptr<const dictionary::PrincipalComponents> components = {};  ///< of some training set; null: none
};

struct BuiltRepresentation {
  std::shared_ptr<const Brdf> brdf;  ///< evaluated as it is kept: factors and codes without a table
  /// The same values at the nodes of the subject's table, where a table of them is at hand; else null.
  std::shared_ptr<const TabulatedBrdf> nodes;
  std::size_t bytes = 0;     ///< see StudyRecord
  double encodeSeconds = 0;  ///< see StudyRecord
  /// Its values at the nodes of the subject's table, computed when they are asked for (a code is decoded in under 50
  /// ms, other things are sampled). From any thread, also when the builder is gone. @throws Cancelled.
  std::function<std::shared_ptr<const TabulatedBrdf>(const TaskControl&)> tabulated = {};
  std::optional<fitting::FitResult> fit = {};  ///< of a fit
};

/// Makes representations of one material. What several budgets share is computed once: factors are nested; fits share
/// their data. Codes are not nested (the dictionary that is best depends on the count): each is encoded by itself.
class RepresentationBuilder {
 public:
  /// @param planned all that will be asked for.
  RepresentationBuilder(StudySubject subject, BuildOptions options, std::span<const Representation> planned);

  /// Deterministic but for the times. Fits and factors about a second, codes two, non-parametric factors some seconds.
  /// @throws Error for a representation that was not planned, more components than there are, or a grid that is not
  /// theirs; Cancelled.
  BuiltRepresentation build(const Representation& representation, const TaskControl& control = {});

 private:
  BuiltRepresentation make(const Representation& representation, const TaskControl& control);
  BuiltRepresentation table(const Representation& representation) const;
  BuiltRepresentation fit(const Representation& representation, const TaskControl& control);
  BuiltRepresentation factors(const Representation& representation, const TaskControl& control);
  BuiltRepresentation code(const Representation& representation, const TaskControl& control);
  BuiltRepresentation components(const Representation& representation, const TaskControl& control) const;
  BuiltRepresentation nonparametric(const TaskControl& control) const;

  StudySubject subject_;
  BuildOptions options_;
  std::map<std::string, int> maxTerms_;  ///< of each form, by the id
  std::shared_ptr<const Brdf> fitBase_;  ///< of the data below
  std::optional<fitting::FitData> fitData_;
  std::map<std::string, factorization::PdvFactorization> factorizations_;
  std::shared_ptr<const TabulatedBrdf> codedTable_;  ///< the table on the dictionary's grid
  std::optional<dictionary::Encoder> encoder_;
};

}  // namespace gonio::study
