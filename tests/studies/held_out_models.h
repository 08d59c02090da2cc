// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/baselines/baselines.h"
#include "core/dictionary/alternatives/patch_dictionary.h"
#include "core/dictionary/encode.h"
#include "core/dictionary/principal_components.h"

/// Models of a material that was held out of a training set: codes over the ensemble, and what the same set teaches
/// other ways.
namespace gonio::study {

using Budgets = std::span<const std::size_t>;
using baselines::ComparedModel;

/// The code in each transform, as its file holds it, and which of them either error would choose.
struct EnsembleModels {
  struct Candidate {
    std::string_view transform;
    baselines::ComparedModel model;
  };
  std::vector<Candidate> candidates;
  std::size_t byGamma = 0;    ///< with the smallest gamma-mapped error, as the encoder chooses
  std::size_t bySquares = 0;  ///< with the smallest squared error
};

/// @param coefficients per channel.
EnsembleModels ensembleModels(const dictionary::Encoder& encoder, const TabulatedBrdf& table, std::size_t coefficients);

/// Principal components of the training set (Nielsen et al. 2015): as many coefficients in half precision, and a scale
/// a channel, as a budget holds, or all components.
std::vector<baselines::ComparedModel> componentModels(const dictionary::PrincipalComponents& components,
                                                      const TabulatedBrdf& table, Budgets budgets);

/// Codes of patches (Aharon et al. 2006) of about as many bytes as each budget.
std::vector<baselines::ComparedModel> patchModels(const dictionary::PatchDictionary& dictionary,
                                                  const TabulatedBrdf& table, Budgets budgets);

}  // namespace gonio::study
