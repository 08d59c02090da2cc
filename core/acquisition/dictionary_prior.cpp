// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/dictionary_prior.h"

#include <algorithm>
#include <numeric>

#include "core/dictionary/gram.h"
#include "core/dictionary/largest_coefficients.h"
#include "core/dictionary/shared_subspace.h"
#include "core/math/parallel.h"
#include "core/support/number_text.h"

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

/// Of each signal (row) the energy in its largest coefficients over each dictionary (column).
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

}  // namespace gonio::acquisition
