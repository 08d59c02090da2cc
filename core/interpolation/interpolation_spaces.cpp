// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/interpolation/interpolation_spaces.h"

#include <algorithm>

#include "core/brdf/weighted_sum.h"
#include "core/dictionary/code_interpolation.h"
#include "core/dictionary/decode.h"
#include "core/editing/edit.h"
#include "core/factorization/deviation_grid.h"
#include "core/factorization/pdv_blend.h"
#include "core/interpolation/measured_detail.h"
#include "core/models/model.h"
#include "core/models/registry.h"
#include "core/support/error.h"

namespace gonio::interpolation {

namespace {

class LinearInterpolation final : public Interpolation {
 public:
  LinearInterpolation(std::span<const InterpolationMaterial> ends, const TaskControl& control)
      : Interpolation(ends), sameGrid_(onOneGrid(this->tables(), control)) {}
  bool mixesNativeForms() const override { return true; }

 private:
  std::shared_ptr<const Brdf> blendedBrdf(std::span<const double> weights) const override {
    std::vector<std::shared_ptr<const Brdf>> materials;
    for (const InterpolationMaterial& end : ends()) materials.push_back(end.material());
    return weightedSum(std::move(materials), {weights.begin(), weights.end()});
  }
  Table blendedTable(std::span<const double> weights, const TaskControl& control) const override {
    return weightedSum(sameGrid_, weights, control);
  }
  std::shared_ptr<const TransformedMixture> mixture() const override { return mixtureOf(sameGrid_); }

  std::vector<Table> sameGrid_;
};

}  // namespace

std::shared_ptr<const TransformedMixture> mixtureOf(const std::vector<Interpolation::Table>& tables) {
  auto mixture = std::make_shared<TransformedMixture>();
  for (const Interpolation::Table& table : tables)
    mixture->tables.push_back({table->grid(),
                               {table->values().begin(), table->values().end()},
                               {table->valid().begin(), table->valid().end()}});
  return mixture;
}

std::vector<Interpolation::Table> tablesOf(std::span<const InterpolationMaterial> ends) {
  std::vector<Interpolation::Table> tables;
  for (const InterpolationMaterial& end : ends) tables.push_back(end.table);
  return tables;
}

std::vector<Interpolation::Table> onOneGrid(const std::vector<Interpolation::Table>& tables,
                                            const TaskControl& control) {
  std::vector<Interpolation::Table> result;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const double each = 1 / double(tables.size());
    result.push_back(onGrid(tables[i], tables[0]->grid(), control.between(double(i) * each, double(i + 1) * each)));
  }
  return result;
}

std::shared_ptr<const Interpolation> prepareLinear(std::span<const InterpolationMaterial> ends,
                                                   const TaskControl& control) {
  return std::make_shared<const LinearInterpolation>(ends, control);
}

namespace {

using factorization::PdvFactors;
using Factors = std::shared_ptr<const PdvFactors>;

class FactorInterpolation final : public Interpolation {
 public:
  /// @throws Error when the factors cannot be blended.
  FactorInterpolation(std::span<const InterpolationMaterial> materials, std::vector<Factors> factors,
                      bool preservesDetail)
      : Interpolation(materials, preservesDetail), factors_(std::move(factors)) {
    factorization::checkBlendable(curves());
    // Those that are given may have nodes of their own, where a blend of other nodes would not return to them.
    if (preservesDetail)
      for (Factors& one : factors_)
        one = std::make_shared<const PdvFactors>(factorization::atNodesOf(*factors_[0], *one));
  }

 private:
  std::shared_ptr<const Brdf> blendedBrdf(std::span<const double> weights) const override {
    return factorization::makePdvBrdf(blended(weights));
  }
  std::optional<PdvFactors> blendedFactors(std::span<const double> weights) const override { return blended(weights); }
  PdvFactors blended(std::span<const double> weights) const {
    return factorization::blended(
        curves(), weights,
        preservesDetail() ? factorization::BlendForm::continuous : factorization::BlendForm::published);
  }
  std::vector<const PdvFactors*> curves() const {
    std::vector<const PdvFactors*> curves;
    for (const Factors& factors : factors_) curves.push_back(factors.get());
    return curves;
  }

  std::vector<Factors> factors_;
};

/// The options that all factorisations share: those of the first material that has factors, else nodes for the set.
factorization::PdvOptions sharedOptions(std::span<const InterpolationMaterial> ends,
                                        const InterpolationOptions& options, const TaskControl& control) {
  for (const InterpolationMaterial& end : ends)
    if (end.factors)
      return {.form = end.factors->form,
              .transform = end.factors->transform,
              .terms = end.factors->terms(),
              .deviationNodes = end.factors->deviationNodes};
  factorization::PdvOptions shared = options.pdv;
  if (shared.deviationNodes.empty() && !ends.empty())
    shared.deviationNodes = factorization::deviationNodes(tablesOf(ends), factorization::defaultDeviations, control);
  return shared;
}

}  // namespace

std::shared_ptr<const Interpolation> prepareFactors(std::span<const InterpolationMaterial> ends,
                                                    const InterpolationOptions& options, const TaskControl& control) {
  constexpr double nodesFraction = 0.1;
  const factorization::PdvOptions shared = sharedOptions(ends, options, control.between(0, nodesFraction));
  std::vector<Factors> factors;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double each = (1 - nodesFraction) / double(ends.size()), begin = nodesFraction + double(i) * each;
    factors.push_back(ends[i].factors
                          ? ends[i].factors
                          : std::make_shared<const PdvFactors>(
                                factorizePdv(*ends[i].table, shared, control.between(begin, begin + each)).factors));
  }
  return std::make_shared<const FactorInterpolation>(ends, std::move(factors), options.preserveDetail);
}

namespace {

using models::ParameterValues;

/// The model alone at the blended parameters.
class ParameterInterpolation : public Interpolation {
 public:
  ParameterInterpolation(std::span<const InterpolationMaterial> ends, const models::Model& model,
                         std::vector<ParameterValues> fitted, bool preservesDetail)
      : Interpolation(ends, preservesDetail), model_(model), fitted_(std::move(fitted)) {}

 protected:
  std::shared_ptr<const Brdf> blendedBrdf(std::span<const double> weights) const override {
    return model_.instantiate(models::blended(model_.spec(), fitted_, weights));
  }
  std::optional<ParameterValues> blendedParameters(std::span<const double> weights) const override {
    return models::blended(model_.spec(), fitted_, weights);
  }
  std::vector<editing::DifferentialEdit> blendedEdits(std::span<const double> weights) const override {
    return preservesDetail() ? editsTo(blendedParameters(weights).value()) : std::vector<editing::DifferentialEdit>{};
  }

  /// One edit per material, from its fitted parameters to others.
  std::vector<editing::DifferentialEdit> editsTo(const ParameterValues& target) const {
    std::vector<editing::DifferentialEdit> edits;
    for (const ParameterValues& fitted : fitted_) edits.push_back({&model_, fitted, target});
    return edits;
  }

  const models::Model& model_;
  std::vector<ParameterValues> fitted_;
};

/// The materials moved to the blended parameters, blended.
class DifferentialInterpolation final : public ParameterInterpolation {
 public:
  DifferentialInterpolation(std::span<const InterpolationMaterial> ends, const models::Model& model,
                            std::vector<ParameterValues> fitted, const TaskControl& control)
      : ParameterInterpolation(ends, model, std::move(fitted), false), sameGrid_(onOneGrid(this->tables(), control)) {}
  bool mixesNativeForms() const override { return true; }

 private:
  std::vector<editing::DifferentialEdit> blendedEdits(std::span<const double> weights) const override {
    return editsTo(blendedParameters(weights).value());
  }
  std::shared_ptr<const Brdf> blendedBrdf(std::span<const double> weights) const override {
    std::vector<std::shared_ptr<const Brdf>> moved;
    for (editing::DifferentialEdit& move : blendedEdits(weights))
      moved.push_back(editing::applyEdits(ends()[moved.size()].material(), editing::EditList{{std::move(move)}}));
    return weightedSum(std::move(moved), {weights.begin(), weights.end()});
  }
  Table blendedTable(std::span<const double> weights, const TaskControl& control) const override {
    const std::vector<editing::DifferentialEdit> edits = blendedEdits(weights);
    std::vector<Table> moved = sameGrid_;
    for (std::size_t i = 0; i < materials(); ++i) {
      if (!(weights[i] > 0)) continue;
      const double begin = double(i) / double(materials()), end = double(i + 1) / double(materials());
      moved[i] = editing::bakeEdits(sameGrid_[i], editing::EditList{{edits[i]}}, control.between(begin, end));
    }
    return weightedSum(moved, weights, {.stop = control.stop});
  }

  std::shared_ptr<const TransformedMixture> mixture() const override { return mixtureOf(sameGrid_); }

  std::vector<Table> sameGrid_;
};

}  // namespace

std::shared_ptr<const Interpolation> prepareParametric(std::span<const InterpolationMaterial> ends, bool isDifferential,
                                                       const InterpolationOptions& options,
                                                       const TaskControl& control) {
  const models::Model& model = options.model ? *options.model : models::ggx();
  std::vector<ParameterValues> fitted;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double begin = double(i) / double(ends.size()), end = double(i + 1) / double(ends.size());
    fitted.push_back(fitting::fit(*ends[i].table, model, options.fit, control.between(begin, end)).parameters);
    control.throwIfStopped();
  }
  if (isDifferential)
    return std::make_shared<const DifferentialInterpolation>(ends, model, std::move(fitted),
                                                             TaskControl{control.stop, {}});
  return std::make_shared<const ParameterInterpolation>(ends, model, std::move(fitted), options.preserveDetail);
}

namespace {

using dictionary::Ensemble;
using dictionary::SparseCode;

/// With the bounds of the code, so that a mixture is within those of the blended code.
TransformedTable decodedSignals(const Ensemble& ensemble, const SparseCode& code) {
  const auto signals = dictionary::decodeSignals(ensemble, code);
  const auto geometry = dictionary::GridGeometry::of(code.grid);
  TransformedTable table{code.grid, {}, geometry->aboveHorizon};
  table.values.resize(code.grid.size());
  for (std::size_t cell = 0; cell < table.values.size(); ++cell)
    for (std::size_t c = 0; c < 3; ++c) {
      const double bound =
          transformed(code.transform, double(code.channels[c].largestValue), geometry->weights[Eigen::Index(cell)]);
      table.values[cell][int(c)] = float(std::clamp(signals[c][Eigen::Index(cell)], -bound, bound));
    }
  return table;
}

class DictionaryInterpolation final : public Interpolation {
 public:
  DictionaryInterpolation(std::span<const InterpolationMaterial> ends, std::shared_ptr<const Ensemble> ensemble,
                          std::vector<SparseCode> codes, std::size_t coefficients, bool preservesDetail)
      : Interpolation(ends, preservesDetail),
        ensemble_(std::move(ensemble)),
        codes_(std::move(codes)),
        coefficients_(coefficients) {
    if (preservesDetail) mixture_ = decodedCodes();
  }

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
  /// With all coefficients: a blended code of few would not return to the code of a material as its weight grows to 1.
  std::shared_ptr<const Brdf> change(std::span<const double> weights) const override {
    return changeOfSpace(mixture_, weights);
  }
  std::shared_ptr<const TransformedMixture> mixture() const override { return mixture_ ? mixture_ : decodedCodes(); }
  std::shared_ptr<const TransformedMixture> decodedCodes() const {
    auto mixture = std::make_shared<TransformedMixture>();
    mixture->transform = codes_[0].transform;
    for (const SparseCode& code : codes_) mixture->tables.push_back(decodedSignals(*ensemble_, code));
    return mixture;
  }

  std::shared_ptr<const Ensemble> ensemble_;
  std::vector<SparseCode> codes_;
  std::size_t coefficients_;
  std::shared_ptr<const TransformedMixture> mixture_;  ///< with preserved detail
};

/// The material that is a code whose ensemble, transform and scale all have: the first one. Null if there is none.
const InterpolationMaterial* givenCode(std::span<const InterpolationMaterial> ends) {
  for (const InterpolationMaterial& end : ends)
    if (end.code) return &end;
  return nullptr;
}

std::shared_ptr<const Ensemble> ensembleOf(std::span<const InterpolationMaterial> ends,
                                           const InterpolationOptions& options) {
  const InterpolationMaterial* const given = givenCode(ends);
  return given && given->ensemble ? given->ensemble : options.ensemble;
}

/// The index of the transform with the least gamma error, summed over the materials.
std::size_t bestTransform(std::span<const dictionary::EncodeResult> encoded, std::size_t transforms) {
  std::vector<double> errors(transforms, 0.0);
  for (const dictionary::EncodeResult& material : encoded)
    for (std::size_t t = 0; t < transforms; ++t) errors[t] += material.candidates[t].gammaError;
  return std::size_t(std::min_element(errors.begin(), errors.end()) - errors.begin());
}

std::vector<SparseCode> codesOfOneTransform(std::span<const InterpolationMaterial> ends, const Ensemble& ensemble,
                                            const InterpolationOptions& options, const TaskControl& control) {
  const dictionary::Encoder encoder(ensemble);
  dictionary::EncodeOptions encode = options.encode;
  const InterpolationMaterial* const given = givenCode(ends);
  if (given) {
    encode.transforms = {given->code->transform};
    encode.scaled = given->code->scaled;
  }
  std::vector<SparseCode> codes(ends.size());
  std::vector<dictionary::EncodeResult> encoded;
  std::vector<std::size_t> materials;  // of `encoded`
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (ends[i].code && ends[i].ensemble == given->ensemble && ends[i].code->transform == given->code->transform &&
        ends[i].code->scaled == given->code->scaled) {
      codes[i] = *ends[i].code;
      dictionary::checkCode(ensemble, codes[i]);
      continue;
    }
    const double begin = double(i) / double(ends.size()), end = double(i + 1) / double(ends.size());
    const auto table = dictionary::onCodeGrid(ends[i].table, ensemble, {.stop = control.stop});
    encoded.push_back(encoder.encode(*table, encode, control.between(begin, end)));
    materials.push_back(i);
  }
  const std::size_t best = bestTransform(encoded, encode.transforms.size());
  for (std::size_t m = 0; m < encoded.size(); ++m) codes[materials[m]] = encoded[m].candidates[best].code;
  if (std::ranges::any_of(codes, &SparseCode::hasBothOrders))
    for (SparseCode& code : codes) code = inBothOrders(code);
  return codes;
}

}  // namespace

std::shared_ptr<const Interpolation> prepareDictionary(std::span<const InterpolationMaterial> ends,
                                                       const InterpolationOptions& options,
                                                       const TaskControl& control) {
  const auto ensemble = ensembleOf(ends, options);
  if (!ensemble || ensemble->dictionaries.empty())
    throw Error("interpolation in the space dictionary: found no dictionary, expected one");
  return std::make_shared<const DictionaryInterpolation>(ends, ensemble,
                                                         codesOfOneTransform(ends, *ensemble, options, control),
                                                         options.codeCoefficients, options.preserveDetail);
}

}  // namespace gonio::interpolation
