// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/studies/held_out_models.h"

#include <algorithm>
#include <cmath>

#include "core/dictionary/code_packing.h"
#include "core/dictionary/decode.h"

namespace gonio::study {

using namespace dictionary;

namespace {

baselines::ComparedModel modelOf(const Ensemble& ensemble, const SparseCode& code) {
  const std::vector<std::byte> packed = packChannels(code, CodePrecision::quantised);
  SparseCode read{
      .grid = code.grid, .transform = code.transform, .hasLargestValues = code.hasLargestValues, .channels = {}};
  unpackChannels(packed, CodePrecision::quantised, read);
  return {decode(ensemble, read), packed.size()};
}

}  // namespace

EnsembleModels ensembleModels(const Encoder& encoder, const TabulatedBrdf& table, std::size_t coefficients) {
  const EncodeResult encoded = encoder.encode(table, {.coefficients = coefficients});
  const auto smallest = [&](double EncodedCandidate::*error) {
    return std::size_t(std::ranges::min_element(encoded.candidates, {}, error) - encoded.candidates.begin());
  };
  EnsembleModels models{.candidates = {},
                        .byGamma = smallest(&EncodedCandidate::gammaError),
                        .bySquares = smallest(&EncodedCandidate::squaredError)};
  for (const EncodedCandidate& candidate : encoded.candidates)
    models.candidates.push_back(
        {dataTransformNames[std::size_t(candidate.code.transform)], modelOf(encoder.ensemble(), candidate.code)});
  return models;
}

std::vector<baselines::ComparedModel> componentModels(const PrincipalComponents& components, const TabulatedBrdf& table,
                                                      Budgets budgets) {
  const std::size_t scales = ComponentCode::halfBytes(0), bytesOfOne = ComponentCode::halfBytes(1) - scales;
  const ComponentCode all = encode(components, table, components.count());
  std::vector<baselines::ComparedModel> models;
  for (const std::size_t budget : budgets) {
    const std::size_t fit = (std::max(budget, scales) - scales) / bytesOfOne;
    const ComponentCode code = all.truncated(int(std::min(fit, std::size_t(components.count())))).inHalfPrecision();
    models.push_back({decode(components, code), ComponentCode::halfBytes(code.components())});
  }
  return models;
}

}  // namespace gonio::study
