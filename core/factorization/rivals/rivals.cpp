// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/rivals/rivals.h"

#include <chrono>

#include "core/factorization/rivals/bilgili.h"
#include "core/factorization/rivals/bivariate.h"
#include "core/factorization/rivals/lawrence.h"

namespace gonio::factorization {

namespace {

using Build = RivalModel (*)(const TabulatedBrdf&, std::size_t, const TaskControl&);

template <Build build>
RivalModel timed(const TabulatedBrdf& table, std::size_t byteBudget, const TaskControl& control) {
  const auto start = std::chrono::steady_clock::now();
  RivalModel model = build(table, byteBudget, control);
  model.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return model;
}

RivalModel buildBivariate(const TabulatedBrdf& table, std::size_t byteBudget, const TaskControl& control) {
  const BivariateTable bivariate = averageBivariate(table, bivariateSide(byteBudget), control);
  return {.brdf = makeBivariateBrdf(bivariate), .bytes = bivariate.values.size() * 3 * sizeof(float)};
}

RivalModel buildLawrence(const TabulatedBrdf& table, std::size_t byteBudget, const TaskControl& control) {
  const LawrenceFactors factors = factorizeLawrence(sampleHalfOut(table, lawrenceAxes(), control),
                                                    lawrenceRanks(lawrenceAxes(), byteBudget), control);
  return {.brdf = makeLawrenceBrdf(factors), .bytes = factors.bytes()};
}

RivalModel buildBilgili(const TabulatedBrdf& table, std::size_t byteBudget, const TaskControl& control) {
  const HalfOutAxes axes = bilgiliAxes();
  const BilgiliFactors factors =
      factorizeBilgili(sampleHalfOut(table, axes, control), bilgiliTerms(axes, byteBudget), control);
  return {.brdf = makeBilgiliBrdf(factors), .bytes = factors.bytes()};
}

constexpr Rival all[] = {
    {"bivariate", "bivariate table", "Romeiro, Vasilyev and Zickler 2008, \"Passive Reflectometry\"",
     timed<buildBivariate>},
    {"lawrence", "non-negative matrices in half-out coordinates",
     "Lawrence, Rusinkiewicz and Ramamoorthi 2004, \"Efficient BRDF Importance Sampling Using a Factored "
     "Representation\"",
     timed<buildLawrence>},
    {"bilgili", "recursive Tucker of the luminance",
     "Bilgili, Öztürk and Kurt 2011, \"A General BRDF Representation Based on Tensor Decomposition\"",
     timed<buildBilgili>},
};

}  // namespace

std::span<const Rival> rivals() { return all; }

}  // namespace gonio::factorization
