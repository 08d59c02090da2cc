// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>

#include "core/baselines/neural_fit.h"
#include "core/dictionary/alternatives/patch_dictionary.h"
#include "core/dictionary/alternatives/separated_components.h"
#include "core/dictionary/encode.h"
#include "core/factorization/nonparametric.h"
#include "core/factorization/pdv_factors.h"
#include "core/fitting/fit_data.h"
#include "core/materials/dictionary_file.h"
#include "core/study/representation.h"

namespace gonio::study {

/// The material of a study: a table (of both orders of the directions if it is not reciprocal), and the BRDF of the
/// reference picture (the table itself, or the material that it samples).
struct StudySubject {
  std::shared_ptr<const TabulatedBrdf> table;
  std::shared_ptr<const Brdf> reference;
};

/// Options for building representations.
struct BuildOptions {
  fitting::FitOptions fit;
  std::shared_ptr<const materials::NamedEnsemble> dictionary;              ///< null: the bundled one
  std::shared_ptr<const dictionary::PrincipalComponents> components = {};  ///< basis of components; null: none
  std::shared_ptr<const dictionary::SeparatedComponents> separated = {};   ///< of "components-separated"; null: none
  std::shared_ptr<const dictionary::PatchDictionary> patches = {};         ///< null: none
  /// Of the material in the published table (materials/npf_file.h); null: none.
  std::shared_ptr<const factorization::NonparametricFactors> publishedNonparametric = {};
  baselines::NeuralFitOptions neural = {};
};

struct BuiltRepresentation {
  std::shared_ptr<const Brdf> brdf;  ///< evaluated from its native form, e.g. factors and codes without a table
  /// Its values at the nodes of the subject's table, if available as a table; else null.
  std::shared_ptr<const TabulatedBrdf> nodes;
  std::size_t bytes = 0;     ///< see StudyRecord
  double encodeSeconds = 0;  ///< see StudyRecord
  /// Computes its values at the nodes of the subject's table (decodes a code in under 50 ms, samples others). Callable
  /// from any thread, also after the builder was destroyed. @throws Cancelled.
  std::function<std::shared_ptr<const TabulatedBrdf>(const TaskControl&)> tabulated = {};
  std::optional<fitting::FitResult> fit = {};  ///< for a fit
};

/// What the build functions of one material read and share. A build function that makes something that several
/// representations need keeps it here.
struct BuildContext {
  StudySubject subject;
  BuildOptions options;
  std::map<const RepresentationKind*, double> maxBudgets;  ///< of the planned representations

  fitting::FitBase fitBase;  ///< of fitData
  std::optional<fitting::FitData> fitData;
  std::map<const RepresentationKind*, factorization::PdvFactorization> factorizations;
  std::shared_ptr<const TabulatedBrdf> codedTable;  ///< the table on the grid of codes
  std::optional<dictionary::Encoder> encoder;

  /// The reciprocal part of the subject's table, for methods that describe nothing else.
  const std::shared_ptr<const TabulatedBrdf>& mean() {
    if (!mean_) mean_ = meanOfOrders(subject.table);
    return mean_;
  }

 private:
  std::shared_ptr<const TabulatedBrdf> mean_;
};

/// Builds representations of one material by the functions of their rows. Common work is done once: factors with fewer
/// terms are prefixes of one factorisation, except joint ones; fits share their data. Each code is encoded separately,
/// because the best dictionary depends on the number of coefficients.
class RepresentationBuilder {
 public:
  /// @param planned all representations that will be built.
  RepresentationBuilder(StudySubject subject, BuildOptions options, std::span<const Representation> planned);

  /// Deterministic except for times. Fits, factors and most baselines take about a second, codes two, joint factors,
  /// the Gaussian process and non-parametric factors a few seconds, neural BRDFs 12 s. @throws Error for a
  /// representation that was not planned, more components than the basis has, a table with another grid than the
  /// basis, or published factors without BuildOptions::publishedNonparametric; Cancelled.
  BuiltRepresentation build(const Representation& representation, const TaskControl& control = {});

 private:
  BuildContext context_;
};

}  // namespace gonio::study
