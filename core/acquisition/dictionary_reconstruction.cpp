// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/dictionary_reconstruction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "core/acquisition/sample_rows.h"
#include "core/dictionary/decode.h"
#include "core/dictionary/largest_projections.h"
#include "core/dictionary/mode_products.h"
#include "core/dictionary/training_materials.h"
#include "core/math/decompositions.h"
#include "core/math/parallel.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::acquisition {

namespace {

using namespace dictionary;

/// Fraction of the energy that the shared subspace may leave out, and again the atoms of each dictionary.
constexpr double maxLoss = 1e-4;
/// By how many of its coefficients the dictionary of a signal is chosen.
constexpr std::size_t choiceCoefficients = 128;

/// The training signals in the subspace that they share.
struct ProjectedSignals {
  SharedSubspace subspace;
  Matrix<float> signals;  ///< one a column
  double energy = 0;      ///< of the whole signals
  ModeMatrices<double> grams;
  float highest = 0;
};

float highestOf(const TabulatedBrdf& table, DataTransform transform, const GridGeometry& geometry) {
  double highest = 0;
  for (std::size_t cell = 0; cell < table.values().size(); ++cell) {
    if (table.valid()[cell] == 0) continue;
    const TabulatedBrdf::Value& value = table.values()[cell];
    const double largest = double(std::max({value.x, value.y, value.z}));
    highest = std::max(highest, transformed(transform, largest, double(geometry.weights[Eigen::Index(cell)])));
  }
  return float(highest);
}

ProjectedSignals projected(const TrainingMaterials& materials, DataTransform transform, const TaskControl& control) {
  const SignalOptions options{.transforms = {transform}};
  const auto geometry = GridGeometry::of(materials.grid);
  std::vector<float> highest(materials.names.size());
  TrainingMaterials watched = materials;
  watched.load = [&](std::size_t material) {
    auto table = materials.load(material);
    highest[material] = highestOf(*table, transform, *geometry);
    return table;
  };
  ProjectedSignals result;
  result.subspace = findSharedSubspace(watched, options, maxLoss, control.between(0, 0.4));
  result.signals.resize(Eigen::Index(count(result.subspace.ranks)),
                        Eigen::Index(materials.names.size() * options.signalsPerMaterial()));
  forEachProjection(
      result.subspace, materials, options,
      [&](std::size_t signal, std::span<const double> block) {
        result.signals.col(Eigen::Index(signal)) =
            Eigen::Map<const Eigen::VectorXd>(block.data(), Eigen::Index(block.size())).cast<float>();
      },
      control.between(0.4, 0.8));
  result.highest = *std::max_element(highest.begin(), highest.end());
  result.energy = result.signals.cast<double>().squaredNorm() / (1 - result.subspace.loss);
  for (int mode = 0; mode < 3; ++mode) {
    Eigen::MatrixXd& gram = result.grams[std::size_t(mode)];
    gram.setZero(result.subspace.ranks[std::size_t(mode)], result.subspace.ranks[std::size_t(mode)]);
    for (Eigen::Index s = 0; s < result.signals.cols(); ++s)
      addGram(result.signals.col(s).data(), result.subspace.ranks, mode, gram);
  }
  return result;
}

/// Analysis of projected signals by one dictionary, over the atoms of each mode that matter.
class Analysis {
 public:
  Analysis(const ProjectedSignals& signals, const Dictionary& dictionary) : signals_(signals) {
    for (std::size_t mode = 0; mode < 3; ++mode) {
      const Eigen::MatrixXd bases = signals.subspace.bases[mode].leftCols(signals.subspace.ranks[mode]);
      const Eigen::MatrixXd turned = bases.transpose() * dictionary.modes[mode];
      const Eigen::VectorXd energies = turned.cwiseProduct(signals.grams[mode] * turned).colwise().sum();
      std::vector<Eigen::Index> order(std::size_t(energies.size()));
      std::iota(order.begin(), order.end(), Eigen::Index(0));
      std::stable_sort(order.begin(), order.end(),
                       [&](Eigen::Index a, Eigen::Index b) { return energies[a] > energies[b]; });
      order.resize(std::size_t(rankFor(energies(order), maxLoss / 3)));
      std::sort(order.begin(), order.end());
      matrices_[mode] = turned(Eigen::all, order).cast<float>();
      sizes_[mode] = int(order.size());
      atoms_[mode] = std::move(order);
    }
    strides_ = {1, dictionary.modes[0].cols(), dictionary.modes[0].cols() * dictionary.modes[1].cols()};
  }

  std::size_t size() const { return count(sizes_); }
  /// size() coefficients of a signal, until the next call.
  std::span<const float> coefficients(Eigen::Index signal) {
    return {transposedModeProducts(signals_.signals.col(signal).data(), signals_.subspace.ranks, matrices_, workspace_,
                                   -1, {2, 1, 0}),
            size()};
  }
  /// The atoms' index in the dictionary.
  std::uint32_t index(std::size_t position) const {
    const std::size_t n0 = std::size_t(sizes_[0]), n1 = std::size_t(sizes_[1]);
    return std::uint32_t(atoms_[0][position % n0] + strides_[1] * atoms_[1][position / n0 % n1] +
                         strides_[2] * atoms_[2][position / (n0 * n1)]);
  }

 private:
  const ProjectedSignals& signals_;
  std::array<std::vector<Eigen::Index>, 3> atoms_;
  std::array<Eigen::Index, 3> strides_{};
  Sizes sizes_{};
  ModeMatrices<float> matrices_;
  Workspace<float> workspace_;
};

/// The energy in the largest coefficients of each signal (row) over each dictionary (column).
Eigen::MatrixXd keptEnergies(const Ensemble& ensemble, const ProjectedSignals& signals, const TaskControl& control) {
  Eigen::MatrixXd kept(signals.signals.cols(), Eigen::Index(ensemble.dictionaries.size()));
  parallelForBlocks(
      ensemble.dictionaries.size(), 1,
      [&](std::size_t d, std::size_t) {
        Analysis analysis(signals, ensemble.dictionaries[d]);
        std::vector<Coefficient<float>> largest;
        for (Eigen::Index s = 0; s < kept.rows(); ++s) {
          control.throwIfStopped();
          selectLargest(analysis.coefficients(s), choiceCoefficients, largest);
          // In an order of their own, so that the sum does not depend on how they were found.
          std::sort(largest.begin(), largest.end(), isLarger<float>);
          kept(s, Eigen::Index(d)) = energy(std::span<const Coefficient<float>>(largest));
        }
      },
      control);
  return kept;
}

CoefficientPrior priorOf(const Dictionary& dictionary, const ProjectedSignals& signals, const Eigen::VectorXd& weights,
                         double energy, std::size_t cells, std::size_t atoms, const TaskControl& control) {
  Analysis analysis(signals, dictionary);
  Eigen::ArrayXd sums = Eigen::ArrayXd::Zero(Eigen::Index(analysis.size())), squares = sums;
  for (Eigen::Index s = 0; s < weights.size(); ++s) {
    control.throwIfStopped();
    const auto coefficients = analysis.coefficients(s);
    const Eigen::ArrayXd values =
        Eigen::Map<const Eigen::ArrayXf>(coefficients.data(), Eigen::Index(coefficients.size())).cast<double>();
    sums += weights[s] * values;
    squares += weights[s] * values.square();
  }
  std::vector<Coefficient<double>> kept;
  selectLargest(std::span<const double>(squares.data(), std::size_t(squares.size())), atoms, kept);
  std::sort(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.index < b.index; });
  CoefficientPrior prior;
  prior.means.resize(Eigen::Index(kept.size()));
  prior.variances.resize(Eigen::Index(kept.size()));
  double keptSquares = 0;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const Eigen::Index position = Eigen::Index(kept[k].index);
    prior.indices.push_back(analysis.index(kept[k].index));
    prior.means[Eigen::Index(k)] = float(sums[position]);
    prior.variances[Eigen::Index(k)] = float(std::max(0.0, squares[position] - sums[position] * sums[position]));
    keptSquares += squares[position];
  }
  prior.restVariance = std::max(0.0, energy - keptSquares) / double(cells);
  return prior;
}

std::string gridSizeText(const HalfDifferenceGrid& grid) {
  return std::to_string(grid.thetaHCount) + " x " + std::to_string(grid.thetaDCount) + " x " +
         std::to_string(grid.phiDCount) + (grid.reciprocal ? "" : " (whole circle)");
}

void checkPriorInput(const Ensemble& ensemble, const TrainingMaterials& materials,
                     const DictionaryPriorOptions& options) {
  if (materials.names.empty()) throw Error("found no training material for the prior, expected at least one");
  if (ensemble.dictionaries.empty()) throw Error("the ensemble contains no dictionaries");
  if (!(materials.grid == ensemble.grid))
    throw Error("found materials with the grid " + gridSizeText(materials.grid) +
                ", expected that of the dictionaries, " + gridSizeText(ensemble.grid));
  if (options.transform != DataTransform::logPlus && options.transform != DataTransform::cosineLog)
    throw Error("found the transform " + std::string(dataTransformNames[std::size_t(options.transform)]) +
                " for a dictionary prior, expected log-plus or cosine-log");
  if (options.atoms < 1)
    throw Error("found " + std::to_string(options.atoms) + " atoms for a dictionary prior, expected 1 or more");
  if (!(options.sharing > 0 && options.sharing <= 1))
    throw Error("found the weight " + numberText(options.sharing) +
                " for a dictionary prior, expected a number above 0 and at most 1");
}

}  // namespace

DictionaryPrior learnDictionaryPrior(const Ensemble& ensemble, const TrainingMaterials& materials,
                                     const DictionaryPriorOptions& options, const TaskControl& control) {
  checkPriorInput(ensemble, materials, options);
  const ProjectedSignals signals = projected(materials, options.transform, control.between(0, 0.5));
  DictionaryPrior prior{
      .grid = ensemble.grid, .transform = options.transform, .highest = signals.highest, .dictionaries = {}};
  prior.dictionaries.resize(ensemble.dictionaries.size());
  Eigen::MatrixXd weights = Eigen::MatrixXd::Ones(signals.signals.cols(), Eigen::Index(ensemble.dictionaries.size()));
  if (options.sharing < 1) {
    const Eigen::MatrixXd kept = keptEnergies(ensemble, signals, control.between(0.5, 0.75));
    for (Eigen::Index s = 0; s < kept.rows(); ++s) {
      Eigen::Index best = 0;
      kept.row(s).maxCoeff(&best);
      weights.row(s).setConstant(options.sharing);
      weights(s, best) = 1;
    }
  }
  weights.array().rowwise() /= weights.array().colwise().sum();
  const Eigen::VectorXd energies = signals.signals.cast<double>().colwise().squaredNorm() / (1 - signals.subspace.loss);
  parallelForBlocks(
      ensemble.dictionaries.size(), 1,
      [&](std::size_t d, std::size_t) {
        const Eigen::VectorXd own = weights.col(Eigen::Index(d));
        prior.dictionaries[d] = priorOf(ensemble.dictionaries[d], signals, own, own.dot(energies), ensemble.grid.size(),
                                        options.atoms, control);
      },
      control.between(0.75, 1));
  return prior;
}

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

/// The mean of the readings of each node, which count as one, as in SampleRows.
ScaledSamples withoutRepetitions(const ScaledSamples& samples) {
  std::map<std::array<Eigen::Index, 3>, std::vector<Eigen::Index>> groups;
  for (std::size_t s = 0; s < samples.nodes.size(); ++s) groups[samples.nodes[s]].push_back(Eigen::Index(s));
  if (groups.size() == samples.nodes.size()) return samples;
  ScaledSamples result{.nodes = {},
                       .values = Eigen::MatrixX3d(Eigen::Index(groups.size()), 3),
                       .variances = Eigen::VectorXd(Eigen::Index(groups.size()))};
  for (const auto& [node, group] : groups) {
    const auto place = Eigen::Index(result.nodes.size());
    result.nodes.push_back(node);
    result.values.row(place) = samples.values(group, Eigen::all).colwise().mean();
    result.variances[place] = samples.variances(group).mean() / double(group.size());
  }
  return result;
}

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
  return withoutRepetitions(result);
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

/// The posterior distribution given the samples under the prior of one dictionary.
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

  /// The evidence at one standard deviation of the noise.
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
