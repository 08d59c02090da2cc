// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>

#include "core/brdf/weighted_sum.h"
#include "core/dictionary/code_brdf.h"
#include "core/dictionary/code_interpolation.h"
#include "core/dictionary/decode.h"
#include "core/interpolation/interpolation_spaces.h"
#include "core/support/error.h"

namespace gonio::editing {

namespace {

using dictionary::Ensemble;
using dictionary::SparseCode;

TransformedTable decodedSignals(const Ensemble& ensemble, const SparseCode& code) {
  const auto signals = dictionary::decodeSignals(ensemble, code);
  TransformedTable table{code.grid, {}, dictionary::GridGeometry::of(code.grid)->aboveHorizon};
  table.values.resize(code.grid.size());
  for (std::size_t cell = 0; cell < table.values.size(); ++cell)
    for (std::size_t c = 0; c < 3; ++c) table.values[cell][int(c)] = float(signals[c][Eigen::Index(cell)]);
  return table;
}

class DictionaryInterpolation final : public Interpolation {
 public:
  DictionaryInterpolation(std::span<const InterpolationMaterial> ends, std::shared_ptr<const Ensemble> ensemble,
                          std::vector<SparseCode> codes, std::size_t coefficients)
      : Interpolation(ends), ensemble_(std::move(ensemble)), codes_(std::move(codes)), coefficients_(coefficients) {}

 private:
  SparseCode between(std::span<const double> weights) const {
    return dictionary::interpolateCodes(*ensemble_, codes_, weights, coefficients_);
  }
  std::optional<SparseCode> blendedCode(std::span<const double> weights) const override { return between(weights); }
  std::shared_ptr<const Brdf> blendedBrdf(std::span<const double> weights) const override {
    return dictionary::makeCodeBrdf(*ensemble_, between(weights));
  }
  Table blendedTable(std::span<const double> weights, const TaskControl& control) const override {
    if (!(ensemble_->grid == tables()[0]->grid())) return Interpolation::blendedTable(weights, control);
    control.throwIfStopped();
    return dictionary::decode(*ensemble_, between(weights));
  }
  std::optional<TransformedMixture> mixture() const override {
    TransformedMixture mixture{codes_[0].transform, {}};
    for (const SparseCode& code : codes_) mixture.tables.push_back(decodedSignals(*ensemble_, code));
    return mixture;
  }

  std::shared_ptr<const Ensemble> ensemble_;
  std::vector<SparseCode> codes_;
  std::size_t coefficients_;
};

/// The code whose transform and scale all have: the first one. Null if there is none.
const SparseCode* givenCode(std::span<const InterpolationMaterial> ends) {
  for (const InterpolationMaterial& end : ends)
    if (end.code) return end.code.get();
  return nullptr;
}

/// The index of the transform with the least gamma error, summed over the materials.
std::size_t bestTransform(std::span<const dictionary::EncodeResult> encoded, std::size_t transforms) {
  std::vector<double> errors(transforms, 0.0);
  for (const dictionary::EncodeResult& material : encoded)
    for (std::size_t t = 0; t < transforms; ++t) errors[t] += material.candidates[t].gammaError;
  return std::size_t(std::min_element(errors.begin(), errors.end()) - errors.begin());
}

std::vector<SparseCode> codesOfOneTransform(std::span<const InterpolationMaterial> ends,
                                            const InterpolationOptions& options, const TaskControl& control) {
  const dictionary::Encoder encoder(*options.ensemble);
  dictionary::EncodeOptions encode = options.encode;
  const SparseCode* const given = givenCode(ends);
  if (given) {
    encode.transforms = {given->transform};
    encode.scaled = given->scaled;
  }
  std::vector<SparseCode> codes(ends.size());
  std::vector<dictionary::EncodeResult> encoded;
  std::vector<std::size_t> materials;  // of `encoded`
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (ends[i].code && ends[i].code->transform == given->transform && ends[i].code->scaled == given->scaled) {
      codes[i] = *ends[i].code;
      dictionary::checkCode(*options.ensemble, codes[i]);
      continue;
    }
    const double begin = double(i) / double(ends.size()), end = double(i + 1) / double(ends.size());
    const auto table = onGrid(ends[i].table, options.ensemble->grid, {.stop = control.stop});
    encoded.push_back(encoder.encode(*table, encode, control.between(begin, end)));
    materials.push_back(i);
  }
  const std::size_t best = bestTransform(encoded, encode.transforms.size());
  for (std::size_t m = 0; m < encoded.size(); ++m) codes[materials[m]] = encoded[m].candidates[best].code;
  return codes;
}

}  // namespace

std::shared_ptr<const Interpolation> prepareDictionary(std::span<const InterpolationMaterial> ends,
                                                       const InterpolationOptions& options,
                                                       const TaskControl& control) {
  if (!options.ensemble || options.ensemble->dictionaries.empty())
    throw Error("interpolation in the space dictionary: found no dictionary, expected one");
  return std::make_shared<const DictionaryInterpolation>(
      ends, options.ensemble, codesOfOneTransform(ends, options, control), options.codeCoefficients);
}

}  // namespace gonio::editing
