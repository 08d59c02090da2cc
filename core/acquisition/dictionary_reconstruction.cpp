// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/dictionary_reconstruction.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/acquisition/sample_rows.h"
#include "core/dictionary/decode.h"
#include "core/math/decompositions.h"
#include "core/math/parallel.h"
#include "core/support/error.h"
#include "core/support/number_text.h"

namespace gonio::acquisition {

namespace {

using dictionary::Dictionary;
using dictionary::Ensemble;
using dictionary::GridGeometry;

/// Noises that are tried, over restVariance: two a decade.
constexpr int noiseSteps = 9;
double triedNoise(int step) { return std::pow(10.0, 0.5 * step - 2); }

/// The samples in the space of scaled signals.
struct ScaledSamples {
  std::vector<std::array<Eigen::Index, 3>> nodes;  ///< phi_d, theta_d, theta_h
  Eigen::MatrixX3d values;                         ///< samples x channels
  Eigen::VectorXd variances;                       ///< of these, mean of the channels; 0 where no noise is known
};

ScaledSamples scaledSamples(const DictionaryPrior& prior, const SamplingPlan& plan, const MeasuredValues& values) {
  checkMeasured(plan, values);
  const auto geometry = GridGeometry::of(prior.grid);
  const auto count = Eigen::Index(plan.samples.size());
  ScaledSamples result;
  result.values.resize(count, 3);
  result.variances = Eigen::VectorXd::Zero(count);
  const Eigen::Index n0 = prior.grid.phiDCount, n1 = prior.grid.thetaDCount;
  for (Eigen::Index s = 0; s < count; ++s) {
    const auto cell = Eigen::Index(nodeOf(prior.grid, plan.samples[std::size_t(s)]));
    const auto& node =
        result.nodes.emplace_back(std::array<Eigen::Index, 3>{cell % n0, cell / n0 % n1, cell / (n0 * n1)});
    const double scale =
        geometry->cellScaling[0][node[0]] * geometry->cellScaling[1][node[1]] * geometry->cellScaling[2][node[2]];
    const double weight = double(geometry->weights[cell]);
    for (int channel = 0; channel < 3; ++channel) {
      const double rho = values.rgb[std::size_t(s)][channel];
      result.values(s, channel) = scale * transformed(prior.transform, rho, weight);
      if (values.noise.empty()) continue;
      const double deviation =
          scale * values.noise[std::size_t(s)][channel] / inverseSlope(prior.transform, rho, weight);
      result.variances[s] += deviation * deviation / 3;
    }
  }
  return result;
}

/// The atoms of a prior at the samples: samples x atoms.
Eigen::MatrixXd atomsAt(const Dictionary& dictionary, const CoefficientPrior& prior, const ScaledSamples& samples) {
  const Eigen::Index n0 = dictionary.modes[0].cols(), n1 = dictionary.modes[1].cols();
  Eigen::MatrixXd atoms(Eigen::Index(samples.nodes.size()), Eigen::Index(prior.indices.size()));
  for (Eigen::Index k = 0; k < atoms.cols(); ++k) {
    const auto index = Eigen::Index(prior.indices[std::size_t(k)]);
    for (Eigen::Index s = 0; s < atoms.rows(); ++s) {
      const auto& node = samples.nodes[std::size_t(s)];
      atoms(s, k) = dictionary.modes[0](node[0], index % n0) * dictionary.modes[1](node[1], index / n0 % n1) *
                    dictionary.modes[2](node[2], index / (n0 * n1));
    }
  }
  return atoms;
}

/// What the samples say under the prior of one dictionary.
class Posterior {
 public:
  Posterior(const Dictionary& dictionary, const CoefficientPrior& prior, const ScaledSamples& samples)
      : prior_(prior), atoms_(atomsAt(dictionary, prior, samples)) {
    floor_ = std::max(prior.restVariance, std::numeric_limits<double>::min());
    const Eigen::VectorXd roots = (1 + samples.variances.array() / floor_).rsqrt();
    residuals_ = roots.asDiagonal() * (samples.values - (atoms_ * prior.means.cast<double>()).replicate<1, 3>());
    atoms_ = roots.asDiagonal() * atoms_;
    const Eigen::MatrixXd scaled = atoms_ * prior.variances.cast<double>().cwiseSqrt().asDiagonal();
    basis_ = eigenBasis(scaled * scaled.transpose());
    projected_ = basis_.vectors.transpose() * residuals_;
  }

  /// Of one of the noises.
  struct Score {
    double noise = 0, logEvidence = 0, leaveOneOut = 0;
  };
  Score score(double noise) const {
    const Eigen::ArrayXd variances = basis_.values.array() + noise * floor_;
    const double energy = (projected_.array().square().colwise() / variances).sum();
    const Eigen::MatrixXd inverse =
        basis_.vectors * variances.inverse().matrix().asDiagonal() * basis_.vectors.transpose();
    const Eigen::MatrixXd left = (inverse * residuals_).array().colwise() / inverse.diagonal().array();
    // One more value stands at the scale of the training set.
    const double count = double(residuals_.size());
    return {noise, -0.5 * ((count + 1) * std::log((energy + 1) / (count + 1)) + 3 * variances.log().sum()),
            std::sqrt(left.squaredNorm() / count)};
  }

  /// Atoms x channels.
  Eigen::MatrixXd coefficients(double noise) const {
    const Eigen::ArrayXd variances = basis_.values.array() + noise * floor_;
    const Eigen::MatrixXd dual = basis_.vectors * (projected_.array().colwise() / variances).matrix();
    return (prior_.variances.cast<double>().asDiagonal() * (atoms_.transpose() * dual)).colwise() +
           prior_.means.cast<double>();
  }

 private:
  const CoefficientPrior& prior_;
  Eigen::MatrixXd atoms_;
  double floor_ = 0;
  Eigen::MatrixXd residuals_, projected_;
  EigenBasis basis_;
};

bool isBetter(const Posterior::Score& a, const Posterior::Score& b, DictionaryChoice choice) {
  return choice == DictionaryChoice::evidence ? a.logEvidence > b.logEvidence : a.leaveOneOut < b.leaveOneOut;
}

Posterior::Score bestOf(const Posterior& posterior, const DictionaryReconstructionOptions& options) {
  if (options.noise > 0) return posterior.score(options.noise);
  Posterior::Score best = posterior.score(triedNoise(0));
  for (int step = 1; step < noiseSteps; ++step)
    if (const auto score = posterior.score(triedNoise(step)); isBetter(score, best, options.choice)) best = score;
  return best;
}

dictionary::SparseCode sparseCodeOf(const DictionaryPrior& prior, std::size_t chosen,
                                    const Eigen::MatrixXd& coefficients) {
  dictionary::SparseCode code{.grid = prior.grid, .transform = prior.transform, .channels = {}};
  const std::vector<std::uint32_t>& indices = prior.dictionaries[chosen].indices;
  for (Eigen::Index channel = 0; channel < 3; ++channel) {
    dictionary::ChannelCode& result = code.channels[std::size_t(channel)];
    result.dictionary = int(chosen);
    result.highest = prior.highest;
    for (std::size_t k = 0; k < indices.size(); ++k)
      result.coefficients.push_back({indices[k], float(coefficients(Eigen::Index(k), channel))});
    std::sort(result.coefficients.begin(), result.coefficients.end(), dictionary::isLarger<float>);
  }
  return code;
}

void checkDictionaryInput(const Ensemble& ensemble, const DictionaryPrior& prior,
                          const DictionaryReconstructionOptions& options) {
  if (!(prior.grid == ensemble.grid) || prior.dictionaries.empty() ||
      prior.dictionaries.size() != ensemble.dictionaries.size())
    throw Error("the prior belongs to another ensemble: found " + std::to_string(prior.dictionaries.size()) +
                " dictionaries, expected " + std::to_string(ensemble.dictionaries.size()) + " over the same grid");
  for (const CoefficientPrior& one : prior.dictionaries)
    if (std::ranges::any_of(one.indices, [&](std::uint32_t index) { return index >= ensemble.grid.size(); }))
      throw Error("the prior refers to an atom that the dictionaries do not contain");
  if (!(options.noise >= 0 && std::isfinite(options.noise)))
    throw Error("found the noise " + numberText(options.noise) + ", expected a finite number, 0 or more");
}

}  // namespace

DictionaryReconstruction reconstructInDictionaries(const Ensemble& ensemble, const DictionaryPrior& prior,
                                                   const SamplingPlan& plan, const MeasuredValues& values,
                                                   const DictionaryReconstructionOptions& options,
                                                   const TaskControl& control) {
  checkDictionaryInput(ensemble, prior, options);
  const ScaledSamples samples = scaledSamples(prior, plan, values);
  std::vector<Posterior::Score> scores(prior.dictionaries.size());
  parallelForBlocks(
      scores.size(), 1,
      [&](std::size_t d, std::size_t) {
        scores[d] = bestOf(Posterior(ensemble.dictionaries[d], prior.dictionaries[d], samples), options);
      },
      control.between(0, 0.8));
  std::size_t chosen = 0;
  for (std::size_t d = 1; d < scores.size(); ++d)
    if (isBetter(scores[d], scores[chosen], options.choice)) chosen = d;
  const Posterior posterior(ensemble.dictionaries[chosen], prior.dictionaries[chosen], samples);
  DictionaryReconstruction result;
  result.dictionary = int(chosen);
  result.noise = scores[chosen].noise;
  result.logEvidence = scores[chosen].logEvidence;
  result.leaveOneOutError = scores[chosen].leaveOneOut;
  result.code = sparseCodeOf(prior, chosen, posterior.coefficients(result.noise));
  result.table = dictionary::decode(ensemble, result.code);
  control.report(1);
  return result;
}

}  // namespace gonio::acquisition
