// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/interpolation/prepared_blend.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/brdf/weighted_sum.h"
#include "core/interpolation/interpolation_spaces.h"
#include "core/models/registry.h"
#include "widgets/preview/gl/shader_base.h"

namespace gonio::widgets {

namespace {

using interpolation::InterpolationSpace;

struct InterpolationSpaceText {
  Q_DECLARE_TR_FUNCTIONS(interpolation::InterpolationSpace)
};

constexpr double preparedFraction = 0.9;

editing::FactorEdit curvesAlone(factorization::PdvFactors factors) {
  const auto curves = std::make_shared<const factorization::PdvFactors>(std::move(factors));
  editing::FactorEdit edit;
  edit.original = edit.edited = curves;
  edit.preserveDetail = false;
  return edit;
}

/// Only where values are mixed, not transformed ones; an edited material is mixed as its table.
bool mixesItself(const PreparedBlend& blend, const interpolation::InterpolationMaterial& material) {
  return blend.mixture->transform == DataTransform::none && fitsBesideBlends(*material.base) &&
         editing::isIdentity(material.edits);
}

void addOwn(PreviewBlend& shown, const PreparedBlend& blend, std::size_t heaviest) {
  const interpolation::InterpolationMaterial& material = blend.materials[heaviest];
  if (!material.base || !mixesItself(blend, material)) return;
  double second = 0;
  for (std::size_t i = 0; i < shown.weights.size(); ++i)
    if (i != heaviest) second = std::max(second, shown.weights[i]);
  shown.own = material.base;
  shown.ownIndex = heaviest;
  shown.ownFraction = shown.weights[heaviest] - second;
}

/// The weights of one material alone.
std::vector<double> whole(std::size_t material, std::size_t count) {
  std::vector<double> weights(count, 0.0);
  weights[material] = 1;
  return weights;
}

/// Fills what the shader needs to preserve detail: the tables of the materials, and their representations.
void prepareDetail(PreparedBlend& blend, const TaskControl& control) {
  const std::size_t count = blend.materials.size();
  std::vector<interpolation::Interpolation::Table> tables = interpolation::tablesOf(blend.materials);
  blend.codes = blend.interpolation->mixture();
  if (blend.codes)
    for (auto& table : tables) table = onGrid(table, blend.codes->tables[0].grid, {control.stop, {}});
  blend.mixture = interpolation::mixtureOf(tables);
  for (std::size_t i = 0; i < count; ++i)
    if (auto curves = blend.interpolation->factors(whole(i, count)))
      blend.curves.push_back(std::make_shared<const factorization::PdvFactors>(std::move(*curves)));
}

/// Whether the change of the space has another order than the materials, all of which are reciprocal.
bool needsBothOrders(const PreparedBlend& blend, const std::vector<double>& weights) {
  if (blend.codes || (blend.curves.empty() && blend.model->spec().reciprocal)) return false;
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (weights[i] > 0 && !blend.materials[i].material()->isReciprocal()) return false;
  return true;
}

void addDetail(PreviewBlend& shown, const PreparedBlend& blend) {
  shown.codes = blend.codes;
  if (auto curves = blend.interpolation->factors(shown.weights)) {
    shown.curves = {std::make_shared<const factorization::PdvFactors>(std::move(*curves))};
    std::ranges::copy(blend.curves, std::back_inserter(shown.curves));
  }
  shown.bothOrders = needsBothOrders(blend, shown.weights);
}

}  // namespace

bool mixesTables(const PreparedBlend& blend) {
  return blend.mixture &&
         std::ranges::any_of(blend.materials, [](const auto& material) { return material.base != nullptr; });
}

PreparedBlendPtr prepareBlend(interpolation::InterpolationSpace space,
                              const std::vector<interpolation::InterpolationMaterial>& materials,
                              const interpolation::InterpolationOptions& options, const TaskControl& control) {
  auto blend = std::make_shared<PreparedBlend>();
  blend->space = space;
  blend->materials = materials;
  blend->model = options.model ? options.model : &models::ggx();
  for (const interpolation::InterpolationMaterial& material : materials)
    blend->lobes.push_back(std::make_shared<const TabulatedDensity>(*material.material()));
  blend->interpolation =
      interpolation::prepareInterpolation(space, materials, options, control.between(0, preparedFraction));
  control.throwIfStopped();
  if (blend->interpolation->preservesDetail())
    prepareDetail(*blend, control);
  else
    blend->mixture = blend->interpolation->mixture();
  control.report(1);
  return blend;
}

PreviewSubject blendSubject(const PreparedBlend& blend, const std::vector<double>& weights) {
  const auto heaviest = std::size_t(std::max_element(weights.begin(), weights.end()) - weights.begin());
  const interpolation::InterpolationMaterial& dominant = blend.materials[heaviest];
  EditedMaterial material{dominant.table};
  const auto& lobe = blend.lobes[heaviest];
  if (weights[heaviest] == 1) return {dominant.base ? EditedMaterial{dominant.base, dominant.edits} : material, lobe};
  if (blend.mixture) {
    PreviewBlend shown{blend.interpolation, blend.mixture, weights, blend.interpolation->differentialEdits(weights)};
    addOwn(shown, blend, heaviest);
    if (shown.preservesDetail()) addDetail(shown, blend);
    return {std::move(shown), lobe};
  }
  if (const auto parameters = blend.interpolation->parameters(weights))
    return {StandaloneModel{blend.model, *parameters, dominant.table->grid()}, lobe};
  if (auto factors = blend.interpolation->factors(weights)) material.edits = {{curvesAlone(std::move(*factors))}};
  return {material, lobe};
}

QString spaceName(interpolation::InterpolationSpace space) {
  switch (space) {
    case interpolation::InterpolationSpace::linear:
      return InterpolationSpaceText::tr("Linear");
    case interpolation::InterpolationSpace::parameters:
      return InterpolationSpaceText::tr("Parameters");
    case interpolation::InterpolationSpace::differential:
      return InterpolationSpaceText::tr("Differential");
    case interpolation::InterpolationSpace::factors:
      return InterpolationSpaceText::tr("Factors");
    default:
      return InterpolationSpaceText::tr("Dictionary");
  }
}

QString spaceExplanation(interpolation::InterpolationSpace space) {
  switch (space) {
    case interpolation::InterpolationSpace::linear:
      return InterpolationSpaceText::tr(
          "The BRDF values are mixed. An equal mix of a sharp and a wide highlight shows both, like two coats, instead "
          "of one highlight of medium width. All measured detail is preserved.");
    case interpolation::InterpolationSpace::parameters:
      return InterpolationSpaceText::tr(
          "A model is fitted to each material and its parameters are mixed: a highlight of medium width lies between a "
          "sharp and a wide one.");
    case interpolation::InterpolationSpace::differential:
      return InterpolationSpaceText::tr(
          "A differential edit changes each material to the mixed parameters of the model and preserves its measured "
          "detail; then the results are mixed. Source: Tsirikoglou et al. 2016, Differential Appearance Editing for "
          "Measured BRDFs.");
    case interpolation::InterpolationSpace::factors:
      return InterpolationSpaceText::tr(
          "The curves of the PDV factors are mixed: the strength and width of the highlight change gradually.");
    default:
      return InterpolationSpaceText::tr(
          "Each material is approximated by a sum of a few dictionary atoms; the coefficients, and with them the "
          "transformed BRDF values, are mixed.");
  }
}

}  // namespace gonio::widgets
