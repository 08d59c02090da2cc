// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_blend.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>

#include "core/brdf/weighted_sum.h"
#include "core/factorization/pdv_operations.h"
#include "core/support/error.h"

namespace gonio::factorization {

namespace {

using Curve = std::vector<double>;

/// A curve of height 1 as its falling hull and what it has less than that.
struct Hull {
  Curve falling, less;
  double weight;
  BlendForm form;

  Hull(const Curve& curve, double height, double w, BlendForm f) : falling(curve), less(curve), weight(w), form(f) {
    for (double& value : falling) value /= height;
    for (std::size_t i = falling.size() - 1; i-- > 0;) falling[i] = std::max(falling[i], falling[i + 1]);
    for (std::size_t i = 0; i < less.size(); ++i) less[i] = falling[i] - curve[i] / height;
  }

  /// How far from 0 it is at least at `level`, in (0, 1].
  double width(std::span<const double> nodes, double level) const {
    const auto below = std::partition_point(falling.begin(), falling.end(), [&](double v) { return v >= level; });
    if (below == falling.begin()) return nodes.front();
    if (below == falling.end())
      return form == BlendForm::published ? nodes.back() : nodes.back() * (2 - level / falling.back());
    const auto i = std::size_t(below - falling.begin());
    const double fraction = (falling[i - 1] - level) / (falling[i - 1] - falling[i]);
    return nodes[i - 1] + fraction * (nodes[i] - nodes[i - 1]);
  }
};

double blendedWidth(std::span<const double> nodes, const std::vector<Hull>& hulls, double level) {
  double width = 1;
  for (const Hull& hull : hulls) width *= std::pow(hull.width(nodes, level), hull.weight);
  return width;
}

/// The highest level at which the blend is still as wide.
double levelAt(std::span<const double> nodes, const std::vector<Hull>& hulls, double width) {
  constexpr double slack = 1e-12;  // of the powers
  double low = 0, high = 1;
  if (blendedWidth(nodes, hulls, high) >= width * (1 - slack)) return high;
  constexpr int bisections = 50;
  for (int step = 0; step < bisections; ++step) {
    const double level = (low + high) / 2;
    (blendedWidth(nodes, hulls, level) >= width * (1 - slack) ? low : high) = level;
  }
  return low;
}

}  // namespace

std::vector<double> blendedByWidth(std::span<const double> nodes, std::span<const std::vector<double>> curves,
                                   std::span<const double> weights, BlendForm form) {
  std::vector<Hull> hulls;
  double total = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const double height = *std::max_element(curves[i].begin(), curves[i].end());
    if (!(weights[i] > 0) || !(height > 0)) continue;
    hulls.emplace_back(curves[i], height, weights[i], form);
    total += weights[i];
  }
  Curve result(nodes.size(), 0.0);
  if (hulls.empty()) return result;
  for (Hull& hull : hulls) hull.weight /= total;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    result[i] = levelAt(nodes, hulls, nodes[i]);
    for (const Hull& hull : hulls) result[i] -= hull.weight * hull.less[i];
    result[i] = std::max(result[i], 0.0);
  }
  return result;
}

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

PdvTerm blendedFirstTerm(std::span<const PdvFactors* const> ends, std::span<const double> weights, std::size_t channel,
                         BlendForm form) {
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
  sum.f2 = blendedByWidth(ends[0]->deviationNodes, shapes, weights, form);
  return sum;
}

/// A term behind the first: of which material, and which.
struct FurtherTerm {
  std::size_t end, index;
};

/// All, or as many as there is room for: those of the lowest index, since terms explain less and less.
std::vector<FurtherTerm> furtherTerms(std::span<const PdvFactors* const> ends, std::span<const double> weights,
                                      BlendForm form) {
  std::vector<FurtherTerm> terms;
  for (std::size_t index = 1; index < std::size_t(maxPdvTerms); ++index)
    for (std::size_t i = 0; i < ends.size(); ++i)
      if (weights[i] > 0 && index < std::size_t(ends[i]->terms())) terms.push_back({i, index});
  if (form == BlendForm::published) terms.resize(std::min(terms.size(), std::size_t(maxPdvTerms - 1)));
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

PdvFactors atNodesOf(const PdvFactors& nodes, const PdvFactors& factors) {
  checkBlendable(std::array{&nodes, &factors});
  PdvFactors result = factors;
  result.thetaNodes = nodes.thetaNodes;
  result.deviationNodes = nodes.deviationNodes;
  result.phiNodes = nodes.phiNodes;
  for (std::vector<PdvTerm>& terms : result.channels)
    for (PdvTerm& term : terms) term = termOn(nodes, factors, term);
  return result;
}

PdvFactors blended(std::span<const PdvFactors* const> ends, std::span<const double> weights, BlendForm form) {
  assert(!ends.empty() && ends.size() == weights.size());
  checkBlendable(ends);
  if (const auto whole = indexOfFullWeight(weights)) return *ends[*whole];
  PdvFactors result = *ends[0];
  result.lowest = result.highest = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    result.lowest += weights[i] * ends[i]->lowest;
    result.highest += weights[i] * ends[i]->highest;
  }
  const std::vector<FurtherTerm> further = furtherTerms(ends, weights, form);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    result.channels[channel] = {blendedFirstTerm(ends, weights, channel, form)};
    for (const auto& [end, index] : further) {
      PdvTerm term = termOn(*ends[0], *ends[end], ends[end]->channels[channel][index]);
      term.f1 = scaled(term.f1, weights[end]);
      result.channels[channel].push_back(std::move(term));
    }
  }
  return result;
}

}  // namespace gonio::factorization
