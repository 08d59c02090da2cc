// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/code_packing.h"
#include "tests/studies/held_out_models.h"

namespace gonio::study {

using namespace dictionary;

std::vector<baselines::ComparedModel> patchModels(const PatchDictionary& dictionary, const TabulatedBrdf& table,
                                                  Budgets budgets) {
  constexpr double bytesPerCoefficient = 3 * 0.7;  // approximate, of three channels
  constexpr int corrections = 2;
  std::vector<baselines::ComparedModel> models;
  for (const std::size_t budget : budgets) {
    double coefficients = double(budget) / bytesPerCoefficient;
    SparseCode code;
    std::vector<std::byte> packed;
    for (int step = 0; step <= corrections; ++step) {
      code = encode(dictionary, table, std::size_t(coefficients));
      packed = packChannels(code, CodePrecision::quantised);
      coefficients *= double(budget) / double(packed.size());
    }
    models.push_back({decode(dictionary, code), packed.size()});
  }
  return models;
}

}  // namespace gonio::study
