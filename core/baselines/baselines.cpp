// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/baselines.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "core/baselines/bilgili.h"
#include "core/baselines/bivariate.h"
#include "core/baselines/gaussian_process.h"
#include "core/baselines/half_difference_tensor.h"
#include "core/baselines/kautz_mccool.h"
#include "core/baselines/lawrence.h"
#include "core/baselines/mccool.h"
#include "core/factorization/nonparametric.h"
#include "core/support/error.h"

namespace gonio::baselines {

namespace {

using Budgets = std::span<const std::size_t>;
using Models = std::vector<ComparedModel>;

std::size_t largest(Budgets budgets) { return budgets.empty() ? 0 : *std::max_element(budgets.begin(), budgets.end()); }

Models buildBivariate(const TabulatedBrdf& table, Budgets budgets, const TaskControl& control) {
  Models models;
  for (const std::size_t budget : budgets) {
    const BivariateTable bivariate = averageBivariate(table, bivariateSide(budget), control);
    models.push_back({makeBivariateBrdf(bivariate), bivariate.values.size() * 3 * sizeof(float)});
  }
  return models;
}

Models buildLawrence(const TabulatedBrdf& table, Budgets budgets, const TaskControl& control) {
  const HalfOutSamples samples = sampleHalfOut(table, lawrenceAxes(), control);
  Models models;
  for (const std::size_t budget : budgets) {
    const LawrenceFactors factors = factorizeLawrence(samples, lawrenceRanks(samples.axes, budget), control);
    models.push_back({makeLawrenceBrdf(factors), factors.bytes()});
  }
  return models;
}

Models buildBilgili(const TabulatedBrdf& table, Budgets budgets, const TaskControl& control) {
  const HalfOutSamples samples = sampleHalfOut(table, bilgiliAxes(), control.between(0, 0.1));
  std::array<BilgiliFactors, 3> all;
  for (int c = 0; c < 3; ++c)
    all[std::size_t(c)] = factorizeBilgili(samples, bilgiliTerms(samples.axes, largest(budgets) / 3), c,
                                           control.between(0.1 + 0.3 * c, 0.4 + 0.3 * c));
  Models models;
  for (const std::size_t budget : budgets) {
    std::array<BilgiliFactors, 3> channels;
    std::size_t bytes = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      channels[c] = truncateBilgili(all[c], bilgiliTerms(samples.axes, budget / 3), samples);
      bytes += channels[c].bytes();
    }
    models.push_back({makeBilgiliBrdf(std::move(channels)), bytes});
  }
  return models;
}

Models buildBilgiliLuminance(const TabulatedBrdf& table, Budgets budgets, const TaskControl& control) {
  const HalfOutSamples samples = sampleHalfOut(table, bilgiliAxes(), control);
  const BilgiliFactors all = factorizeBilgili(samples, bilgiliTerms(samples.axes, largest(budgets)), {}, control);
  Models models;
  for (const std::size_t budget : budgets) {
    const BilgiliFactors factors = truncateBilgili(all, bilgiliTerms(samples.axes, budget), samples);
    models.push_back({makeBilgiliBrdf(factors), factors.bytes()});
  }
  return models;
}

Models buildKautzMcCool(const TabulatedBrdf& table, Budgets budgets, const TaskControl& control) {
  const factorization::HalfDifferenceSamples samples =
      factorization::sampleHalfDifference(table, kautzMcCoolAxes(), control);
  const KautzMcCoolFactors all =
      factorizeKautzMcCool(samples, kautzMcCoolTerms(samples.axes, largest(budgets)), control);
  Models models;
  for (const std::size_t budget : budgets) {
    const KautzMcCoolFactors factors = all.truncated(kautzMcCoolTerms(samples.axes, budget));
    models.push_back({makeKautzMcCoolBrdf(factors), factors.bytes()});
  }
  return models;
}

Models buildNonnegative(const TabulatedBrdf& table, Budgets budgets, const TaskControl& control) {
  const factorization::HalfDifferenceSamples samples =
      factorization::sampleHalfDifference(table, kautzMcCoolAxes(), control);
  Models models;
  for (const std::size_t budget : budgets) {
    const KautzMcCoolFactors factors =
        factorizeNonnegativeHalfDifference(samples, kautzMcCoolTerms(samples.axes, budget), control);
    models.push_back({makeKautzMcCoolBrdf(factors), factors.bytes()});
  }
  return models;
}

Models buildTensor(const TabulatedBrdf& table, Budgets budgets, const TaskControl& control, auto decompose) {
  const auto samples =
      sampleHalfDifferenceTensor(factorization::sampleHalfDifference(table, kautzMcCoolAxes(), control));
  Models models;
  for (const std::size_t budget : budgets) {
    HalfDifferenceTensor tensor = decompose(samples, budget);
    const std::size_t bytes = tensor.bytes;
    models.push_back({makeHalfDifferenceTensorBrdf(std::move(tensor)), bytes});
  }
  return models;
}

Models buildCp(const TabulatedBrdf& table, Budgets budgets, const TaskControl& control) {
  return buildTensor(table, budgets, control, [&](const HalfDifferenceTensor& tensor, std::size_t budget) {
    return decomposeCp(tensor, cpTerms(tensor.axes, budget), control);
  });
}

Models buildHosvd(const TabulatedBrdf& table, Budgets budgets, const TaskControl& control) {
  return buildTensor(table, budgets, control, [](const HalfDifferenceTensor& tensor, std::size_t budget) {
    return decomposeHosvd(tensor, hosvdRanks(tensor.axes, budget));
  });
}

Models buildCosineSeries(const TabulatedBrdf& table, Budgets budgets, const TaskControl& control) {
  return buildTensor(table, budgets, control, [](const HalfDifferenceTensor& tensor, std::size_t budget) {
    return truncateCosineSeries(tensor, cosineCoefficients(tensor.axes, budget));
  });
}

Models buildMcCool(const TabulatedBrdf& table, Budgets budgets, const TaskControl& control) {
  const McCoolFactors factors =
      factorizeMcCool(factorization::sampleHalfDifference(table, mcCoolAxes(), control), control);
  return Models(budgets.size(), {makeMcCoolBrdf(factors), factors.bytes()});
}

Models buildNonparametric(const TabulatedBrdf& table, Budgets budgets, const TaskControl& control) {
  const factorization::NonparametricFit fit = factorization::fitNonparametric(
      factorization::sampleHalfDifference(table, factorization::nonparametricAxes(), control), {}, control);
  return Models(budgets.size(), {factorization::makeNonparametricBrdf(fit.factors), fit.factors.bytes()});
}

Models buildGaussianProcess(const TabulatedBrdf& table, Budgets budgets, const TaskControl& control) {
  const factorization::HalfDifferenceSamples samples =
      factorization::sampleHalfDifference(table, gaussianAxes(), control);
  Models models;
  for (const std::size_t budget : budgets) {
    GaussianProcess process = fitGaussianProcess(samples, gaussianNodes(budget), control);
    const std::size_t bytes = process.bytes();
    models.push_back({makeGaussianProcessBrdf(std::move(process)), bytes});
  }
  return models;
}

constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();
/// Size of the exact decomposition of the 3 x 90 by 30 x 7 matrix into 210 terms.
constexpr std::size_t exactMatrixBytes = 403'200;

constexpr Baseline rows[] = {
    {"kautz-mccool", "Kautz and McCool 1999", "singular value decomposition in half-difference coordinates",
     "Kautz and McCool 1999, Interactive Rendering with Arbitrary BRDFs using Separable Approximations",
     exactMatrixBytes, buildKautzMcCool},
    {"mccool", "McCool et al. 2001", "homomorphic factorisation",
     "McCool, Ang and Ahmad 2001, Homomorphic Factorization of BRDFs for High-Performance Rendering", 0, buildMcCool},
    {"lawrence", "Lawrence et al. 2004", "non-negative matrix factorisation in half-out coordinates",
     "Lawrence, Rusinkiewicz and Ramamoorthi 2004, Efficient BRDF Importance Sampling Using a Factored "
     "Representation",
     unlimited, buildLawrence},
    {"bivariate", "Romeiro et al. 2008", "bivariate table", "Romeiro, Vasilyev and Zickler 2008, Passive Reflectometry",
     97'200, buildBivariate},
    {"bilgili", "Bilgili et al. 2011", "recursive Tucker decomposition of each channel",
     "Bilgili, Öztürk and Kurt 2011, A General BRDF Representation Based on Tensor Decomposition", unlimited,
     buildBilgili},
    {"bilgili-luminance", "Bilgili et al. 2011, luminance", "recursive Tucker decomposition of the luminance",
     "Bilgili, Öztürk and Kurt 2011, A General BRDF Representation Based on Tensor Decomposition", unlimited,
     buildBilgiliLuminance},
    {"nonparametric", "Bagher et al. 2016", "microfacet model with tabulated factors",
     "Bagher, Snyder and Nowrouzezahrai 2016, A Non-Parametric Factor Microfacet Model for Isotropic BRDFs", 0,
     buildNonparametric},
    {"cp", "CP decomposition", "CP decomposition in half-difference coordinates",
     "Carroll and Chang 1970, Analysis of Individual Differences in Multidimensional Scaling; Kolda and Bader 2009, "
     "Tensor Decompositions and Applications",
     33'284, buildCp},
    {"hosvd", "Higher-order SVD", "higher-order SVD in half-difference coordinates",
     "De Lathauwer, De Moor and Vandewalle 2000, A Multilinear Singular Value Decomposition", 263'036, buildHosvd},
    {"cosine-series", "Cosine series", "discrete cosine transform in half-difference coordinates",
     "Ahmed, Natarajan and Rao 1974, Discrete Cosine Transform", 340'204, buildCosineSeries},
    {"nmf", "Non-negative matrix factorisation", "non-negative matrix factorisation in half-difference coordinates",
     "Lee and Seung 2001, Algorithms for Non-negative Matrix Factorization", exactMatrixBytes, buildNonnegative},
    {"gaussian-process", "Gaussian process", "Gaussian process in half-difference coordinates",
     "Rasmussen and Williams 2006, Gaussian Processes for Machine Learning", 12'312, buildGaussianProcess},
};

}  // namespace

std::span<const Baseline> allBaselines() { return rows; }

const Baseline& findBaseline(std::string_view id) {
  if (const auto found = std::ranges::find(rows, id, &Baseline::id); found != std::end(rows)) return *found;
  std::string known;
  for (const Baseline& baseline : rows) known += (known.empty() ? "" : ", ") + std::string(baseline.id);
  throw Error("found the baseline '" + std::string(id) + "', expected one of " + known);
}

}  // namespace gonio::baselines
