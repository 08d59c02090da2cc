// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>

#include "core/dictionary/code_packing.h"
#include "tests/studies/held_out_models.h"

namespace gonio::study {

using namespace dictionary;

namespace {

/// Fewer than the defaults: the atoms are learned anew for every fold.
constexpr std::size_t samples = 8000;
constexpr int rounds = 15;

PatchTrainingOptions trainingOptions() {
  PatchTrainingOptions options{.samples = samples};
  options.kSvd.iterations = rounds;
  return options;
}

/// By how much a value at a node of theta_h and theta_d is scaled in a signal.
Eigen::ArrayXf scalesOf(const HalfDifferenceGrid& grid, const GridGeometry& geometry) {
  Eigen::ArrayXf scales(Eigen::Index(grid.size()));
  Eigen::Index cell = 0;
  for (int h = 0; h < grid.thetaHCount; ++h)
    for (int d = 0; d < grid.thetaDCount; ++d, cell += grid.phiDCount)
      scales.segment(cell, grid.phiDCount).setConstant(float(geometry.importance[1][d] * geometry.importance[2][h]));
  return scales;
}

float highestOf(const TabulatedBrdf& table, int channel) {
  float highest = 0;
  for (std::size_t cell = 0; cell < table.values().size(); ++cell)
    if (table.valid()[cell] != 0) highest = std::max(highest, table.values()[cell][channel]);
  return std::log1p(highest);
}

}  // namespace

PatchModels::PatchModels(const TrainingMaterials& materials)
    : options_(trainingOptions()), atoms_(learnPatchAtoms(materials, options_).atoms) {}

SparseCode PatchModels::encoded(const std::array<Eigen::MatrixXd, 3>& patches, const TabulatedBrdf& table,
                                std::size_t coefficients) const {
  SparseCode code{.grid = table.grid(), .transform = DataTransform::logPlus, .channels = {}};
  for (int c = 0; c < 3; ++c) {
    ChannelCode& channel = code.channels[std::size_t(c)];
    channel.highest = highestOf(table, c);
    const PatchCode pursued = encodePatches(atoms_, patches[std::size_t(c)], coefficients);
    for (std::size_t p = 0; p < pursued.patches.size(); ++p)
      for (std::size_t i = 0; i < pursued.patches[p].atoms.size(); ++i)
        channel.coefficients.push_back(
            {.index = std::uint32_t(std::size_t(pursued.patches[p].atoms[i]) + std::size_t(atoms_.count()) * p),
             .value = float(pursued.patches[p].coefficients[i])});
    std::ranges::sort(channel.coefficients, isLarger<float>);
  }
  return code;
}

std::shared_ptr<const TabulatedBrdf> PatchModels::decoded(const SparseCode& code) const {
  const auto geometry = GridGeometry::of(code.grid);
  const Eigen::ArrayXf scales = scalesOf(code.grid, *geometry);
  const Sizes sizes = modeSizes(code.grid);
  std::vector<TabulatedBrdf::Value> values(code.grid.size());
  for (int c = 0; c < 3; ++c) {
    const ChannelCode& channel = code.channels[std::size_t(c)];
    Eigen::MatrixXd patches = Eigen::MatrixXd::Zero(atoms_.length(), Eigen::Index(code.grid.size()) / atoms_.length());
    for (const Coefficient<float>& one : channel.coefficients)
      patches.col(Eigen::Index(one.index) / atoms_.count()) +=
          double(one.value) * atoms_.matrix().col(Eigen::Index(one.index) % atoms_.count());
    Eigen::ArrayXf signal = (signalOf(patches, sizes, options_.patch) / scales).min(channel.highest);
    invertTransform(signal, code.transform, geometry->weights);
    for (std::size_t cell = 0; cell < values.size(); ++cell) values[cell][c] = signal[Eigen::Index(cell)];
  }
  return std::make_shared<const TabulatedBrdf>(code.grid, std::move(values), geometry->aboveHorizon);
}

std::vector<ComparedModel> PatchModels::models(const TabulatedBrdf& table, Budgets budgets) const {
  const auto signals = signalsOf(table, DataTransform::logPlus, *GridGeometry::of(table.grid()));
  std::array<Eigen::MatrixXd, 3> patches;
  for (std::size_t c = 0; c < 3; ++c) patches[c] = patchesOf(signals[c], modeSizes(table.grid()), options_.patch);
  constexpr double bytesOfOne = 3 * 3.5;  // of three channels, about
  constexpr int corrections = 2;
  std::vector<ComparedModel> models;
  for (const std::size_t budget : budgets) {
    double coefficients = double(budget) / bytesOfOne;
    SparseCode code;
    std::vector<std::byte> packed;
    for (int step = 0; step <= corrections; ++step) {
      code = encoded(patches, table, std::size_t(coefficients));
      packed = packChannels(code, CodePrecision::quantised);
      coefficients *= double(budget) / double(packed.size());
    }
    if (packed.size() > budget) packed = packChannels(code = truncatedToBytes(code, budget), CodePrecision::quantised);
    unpackChannels(packed, CodePrecision::quantised, code);
    models.push_back({decoded(code), packed.size()});
  }
  return models;
}

}  // namespace gonio::study
