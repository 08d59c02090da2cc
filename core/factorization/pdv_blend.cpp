// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_blend.h"

#include <algorithm>
#include <cassert>
#include <string>

#include "core/factorization/pdv_operations.h"
#include "core/factorization/width_blend.h"
#include "core/math/weights.h"
#include "core/support/error.h"

namespace gonio::factorization {

namespace {

using Curve = std::vector<double>;

Curve onNodes(const Curve& nodes, const Curve& curve, const Curve& newNodes) {
  return nodes == newNodes ? curve : resampled(nodes, curve, newNodes);
}

/// A term of `end` on the nodes of `axes`.
PdvTerm termOn(const PdvFactors& axes, const PdvFactors& end, const PdvTerm& term) {
  return {onNodes(end.thetaNodes, term.f1, axes.thetaNodes), onNodes(end.deviationNodes, term.f2, axes.deviationNodes),
          onNodes(end.phiNodes, term.f3, axes.phiNodes)};
}

void add(Curve& sum, const Curve& curve, double weight) {
  if (sum.empty()) sum.assign(curve.size(), 0.0);
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * curve[i];
}

PdvTerm blendedFirstTerm(std::span<const PdvFactors* const> ends, std::span<const double> weights,
                         std::size_t channel) {
  PdvTerm sum;
  std::vector<Curve> shapes;
  double shaped = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    PdvTerm term = termOn(*ends[0], *ends[i], ends[i]->channels[channel].front());
    // F1 takes up the height of F2, which is 1 unless it was edited.
    const double height = *std::max_element(term.f2.begin(), term.f2.end());
    add(sum.f1, term.f1, weights[i] * height);
    // What has no strength has no shape either: black dims a material and does not change it.
    const double fraction = height > 0 ? weights[i] : 0;
    add(sum.f3, term.f3, fraction);
    shaped += fraction;
    shapes.push_back(std::move(term.f2));
  }
  if (shaped > 0) sum.f3 = scaled(sum.f3, 1 / shaped);
  sum.f2 = blendedByWidth(ends[0]->deviationNodes, shapes, weights);
  return sum;
}

/// A term behind the first: of which material, and which.
struct FurtherTerm {
  std::size_t end, index;
};

/// As many as there is room for: those of the lowest index, since terms explain less and less.
std::vector<FurtherTerm> furtherTerms(std::span<const PdvFactors* const> ends, std::span<const double> weights) {
  std::vector<FurtherTerm> terms;
  for (std::size_t index = 1; index < std::size_t(maxPdvTerms); ++index)
    for (std::size_t i = 0; i < ends.size(); ++i)
      if (weights[i] > 0 && index < std::size_t(ends[i]->terms())) terms.push_back({i, index});
  terms.resize(std::min(terms.size(), std::size_t(maxPdvTerms - 1)));
  return terms;
}

}  // namespace

void checkBlendable(std::span<const PdvFactors* const> ends) {
  for (const PdvFactors* end : ends) {
    if (end->transform != ends[0]->transform)
      throw Error("the transforms of the factors are " +
                  std::string(dataTransformNames[std::size_t(ends[0]->transform)]) + " and " +
                  std::string(dataTransformNames[std::size_t(end->transform)]) + "; expected the same");
    if (end->form != ends[0]->form)
      throw Error(
          "factors with two curves and factors with three cannot be blended; expected the same number of curves");
  }
}

PdvFactors blended(std::span<const PdvFactors* const> ends, std::span<const double> weights) {
  assert(!ends.empty() && ends.size() == weights.size());
  checkBlendable(ends);
  if (const auto whole = indexOfFullWeight(weights)) return *ends[*whole];
  PdvFactors result = *ends[0];
  result.highest = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) result.highest += weights[i] * ends[i]->highest;
  const std::vector<FurtherTerm> further = furtherTerms(ends, weights);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    result.channels[channel] = {blendedFirstTerm(ends, weights, channel)};
    for (const auto& [end, index] : further) {
      PdvTerm term = termOn(*ends[0], *ends[end], ends[end]->channels[channel][index]);
      term.f1 = scaled(term.f1, weights[end]);
      result.channels[channel].push_back(std::move(term));
    }
  }
  return result;
}

}  // namespace gonio::factorization
