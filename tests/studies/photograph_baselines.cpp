// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/studies/photograph_baselines.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/fitting/bounded_least_squares.h"
#include "core/fitting/projected_problem.h"
#include "core/models/registry.h"

namespace gonio::study {

using photograph::PhotographPrior, photograph::PhotographSet, photograph::Region;

namespace {

/// Differences relative to the pixel values, as in the reconstruction.
void differences(const ImageData& data, const std::vector<glm::vec3>& cellValues, std::span<double> out) {
  const std::vector<Rgb> values = data.rows.values(cellValues);
  Rgb mean(0);
  for (const Region& region : data.regions) mean += region.value / double(data.regions.size());
  for (std::size_t row = 0; row < values.size(); ++row)
    for (int channel = 0; channel < 3; ++channel) {
      const double value = data.regions[row].value[channel];
      out[3 * row + std::size_t(channel)] =
          (values[row][channel] - value) / (std::abs(value) + 0.02 * mean[channel] + 1e-9);
    }
}

/// The parameters of a model that best reproduce the photograph, from each of some starts.
std::shared_ptr<const Brdf> fittedModel(const ImageData& data, const models::Model& model,
                                        const std::vector<models::ParameterValues>& starts, int iterations) {
  const auto specs = model.spec().parameters;
  struct Unknown {
    std::size_t parameter;
    int channel;
    fitting::UnitScale scale;
  };
  std::vector<Unknown> unknowns;
  for (std::size_t p = 0; p < specs.size(); ++p) {
    if (!specs[p].choices.empty() || specs[p].id.find("retro") != std::string_view::npos) continue;
    for (int channel = 0; channel < (specs[p].perChannel ? 3 : 1); ++channel)
      unknowns.push_back({p, specs[p].perChannel ? channel : -1, fitting::UnitScale(specs[p])});
  }
  std::shared_ptr<const Brdf> best;
  double least = std::numeric_limits<double>::infinity();
  std::vector<Rgb> values(data.pairs.size());
  std::vector<glm::vec3> cells(data.pairs.size());
  std::vector<double> residuals(3 * data.rows.count());
  for (const models::ParameterValues& start : starts) {
    const auto valuesAt = [&](std::span<const double> x) {
      models::ParameterValues parameters = start;
      for (std::size_t i = 0; i < unknowns.size(); ++i) {
        Rgb& of = parameters.values[unknowns[i].parameter];
        const double value = unknowns[i].scale.toValue(x[i]);
        if (unknowns[i].channel < 0)
          of = Rgb(value);
        else
          of[unknowns[i].channel] = value;
      }
      return parameters;
    };
    const auto compute = [&](std::span<const double> x, std::span<double> out) {
      model.instantiate(valuesAt(x))->evaluate(data.pairs, values);
      std::copy(values.begin(), values.end(), cells.begin());
      differences(data, cells, out);
    };
    fitting::BoundedVariables variables;
    for (const Unknown& unknown : unknowns) {
      const double minimum = std::max(-1.0, unknown.scale.minimum()), maximum = std::min(3.0, unknown.scale.maximum());
      variables.minimum.push_back(minimum);
      variables.maximum.push_back(maximum);
      const Rgb& of = start.values[unknown.parameter];
      variables.start.push_back(std::clamp(unknown.scale.toUnit(of[std::max(0, unknown.channel)]), minimum, maximum));
    }
    const auto x = fitting::boundedLeastSquares(compute, residuals.size(), variables, iterations);
    compute(x, residuals);
    double sum = 0;
    for (const double r : residuals) sum += r * r;
    if (!(sum < least)) continue;
    least = sum;
    best = model.instantiate(valuesAt(x));
  }
  return best;
}

}  // namespace

ImageData imageData(const PhotographPrior& prior, const PhotographSet& set) {
  ImageData data{.regions = photograph::regionsOf(set, 150), .rows = {}, .pairs = {}};
  data.rows = photograph::assembleRows(prior.mapping, set, data.regions);
  for (const std::uint32_t cell : prior.mapping.cells) data.pairs.push_back(prior.mapping.grid.directions(cell));
  return data;
}

std::shared_ptr<const Brdf> fittedGgx(const ImageData& data) {
  const models::Model& model = models::findModel("ggx");
  std::vector<models::ParameterValues> starts;
  for (const double roughness : {0.1, 0.35}) {
    starts.push_back(models::defaultParameters(model.spec()));
    starts.back().values[*model.spec().find("roughness")] = Rgb(roughness);
  }
  return fittedModel(data, model, starts, 20);
}

std::shared_ptr<const Brdf> fittedLobes(const ImageData& data) {
  const models::Model& model = models::findModel("layered");
  models::ParameterValues start = models::defaultParameters(model.spec());
  for (std::size_t p = 0; p < model.spec().parameters.size(); ++p) {
    const auto& spec = model.spec().parameters[p];
    if (!spec.choices.empty() && spec.id.find("retro") == std::string_view::npos) start.values[p] = Rgb(1);
  }
  return fittedModel(data, model, {start}, 12);
}

std::shared_ptr<const Brdf> nearest(const ImageData& data, const PhotographPrior& prior,
                                    std::span<const std::string> names,
                                    std::span<const std::shared_ptr<const TabulatedBrdf>> tables,
                                    const std::string& left, std::string& name) {
  std::shared_ptr<const Brdf> best;
  double least = std::numeric_limits<double>::infinity();
  std::vector<glm::vec3> cells(prior.mapping.cells.size());
  std::vector<double> residuals(3 * data.rows.count());
  for (std::size_t m = 0; m < names.size(); ++m) {
    if (names[m] == left) continue;
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = tables[m]->values()[prior.mapping.cells[i]];
    differences(data, cells, residuals);
    double sum = 0;
    for (const double r : residuals) sum += std::min(r * r, 1e6);
    if (!(sum < least)) continue;
    least = sum;
    best = tables[m];
    name = names[m];
  }
  return best;
}

}  // namespace gonio::study
