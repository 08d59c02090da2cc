// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/representation_builder.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>

#include "core/brdf/weighted_sum.h"
#include "core/dictionary/decode.h"
#include "core/fitting/fit_parameters.h"
#include "core/formats/code.h"
#include "core/formats/neural.h"
#include "core/formats/pdv.h"
#include "core/models/registry.h"

namespace gonio::study {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// A table read without interpolation.
class CellLookupBrdf final : public Brdf {
 public:
  explicit CellLookupBrdf(std::shared_ptr<const TabulatedBrdf> table) : table_(std::move(table)) {}
  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    table_->evaluate(pairs, values, TableLookup::cell);
  }

 private:
  std::shared_ptr<const TabulatedBrdf> table_;
};

bool isFactors(const Representation& representation) { return representation.id.starts_with("factors-"); }

factorization::PdvOptions pdvOptionsOf(const Representation& representation, int terms) {
  using namespace factorization;
  const PdvForm form = representation.id.starts_with("factors-2d") ? PdvForm::twoFactors : PdvForm::threeFactors;
  if (representation.family == RepresentationFamily::published) return publishedPdvOptions(form, terms);
  const PdvOptions options{
      .form = form, .terms = terms, .joint = representation.family == RepresentationFamily::alternatives};
  return representation.id.ends_with("-compact") ? compactPdvOptions(options) : options;
}

dictionary::EncodeOptions encodeOptionsOf(const Representation& representation) {
  const auto coefficients = std::size_t(representation.budget);
  const bool isPublished = representation.family == RepresentationFamily::published;
  dictionary::EncodeOptions options = isPublished ? dictionary::publishedEncodeOptions(coefficients)
                                                  : dictionary::EncodeOptions{.coefficients = coefficients};
  options.quantised = true;
  if (representation.family == RepresentationFamily::alternatives)
    options.method = dictionary::CodingMethod::basisPursuit;
  return options;
}

std::size_t halfBytesOf(const dictionary::ComponentCode& code) {
  return dictionary::ComponentCode::halfBytes(code.components());
}
std::size_t halfBytesOf(const dictionary::SeparatedCode& code) { return code.halfBytes(); }

/// The material by the first components of a basis, as a file in half precision restores it.
/// @tparam Basis dictionary::PrincipalComponents or SeparatedComponents.
template <typename Basis>
BuiltRepresentation fromComponents(const Basis& basis, const Representation& representation, const TabulatedBrdf& table,
                                   const TaskControl& control) {
  const int count = int(representation.budget);
  if (count > basis.count())
    throw Error(representation.fullLabel() + ": the training set has only " + std::to_string(basis.count()) +
                " principal components");
  const auto start = Clock::now();
  const auto encoded = dictionary::encode(basis, table, count, control);
  const double seconds = secondsSince(start);
  const auto decoded = dictionary::decode(basis, encoded.inHalfPrecision(), {.stop = control.stop, .progress = {}});
  return {.brdf = decoded,
          .nodes = decoded,
          .bytes = halfBytesOf(encoded),
          .encodeSeconds = seconds,
          .tabulated = [decoded](const TaskControl&) { return decoded; }};
}

}  // namespace

RepresentationBuilder::RepresentationBuilder(StudySubject subject, BuildOptions options,
                                             std::span<const Representation> planned)
    : subject_(std::move(subject)), options_(std::move(options)) {
  for (const Representation& representation : planned)
    if (isFactors(representation)) {
      int& most = maxTerms_[representation.id];
      most = std::max(most, int(representation.budget));
    }
}

BuiltRepresentation RepresentationBuilder::build(const Representation& representation, const TaskControl& control) {
  BuiltRepresentation built = make(representation, control);
  if (!built.tabulated)
    built.tabulated = [brdf = built.brdf, grid = subject_.table->grid()](const TaskControl& baking) {
      return bakeTable(*brdf, grid, baking);
    };
  return built;
}

BuiltRepresentation RepresentationBuilder::make(const Representation& representation, const TaskControl& control) {
  switch (representation.family) {
    case RepresentationFamily::table:
      return table(representation);
    case RepresentationFamily::fit:
      return fit(representation, control);
    case RepresentationFamily::factors:
      return factors(representation, control);
    case RepresentationFamily::published:
    case RepresentationFamily::alternatives:
      return isFactors(representation) ? factors(representation, control) : code(representation, control);
    case RepresentationFamily::code:
      return code(representation, control);
    case RepresentationFamily::components:
      return representation.id == separatedComponentsId ? separated(representation, control)
                                                        : components(representation, control);
    case RepresentationFamily::patches:
      return patches(representation, control);
    case RepresentationFamily::nonparametric:
      return nonparametric(control);
    case RepresentationFamily::publishedNonparametric:
      return publishedNonparametric();
    case RepresentationFamily::neural:
      return neuralBrdf(control);
    case RepresentationFamily::baselines:
      break;
  }
  return baseline(representation, control);
}

BuiltRepresentation RepresentationBuilder::table(const Representation& representation) const {
  BuiltRepresentation built{.brdf = subject_.table, .nodes = subject_.table, .bytes = subject_.table->bytes()};
  built.tabulated = [all = subject_.table](const TaskControl&) { return all; };
  if (representation.id == "table-nearest") built.brdf = std::make_shared<const CellLookupBrdf>(subject_.table);
  return built;
}

BuiltRepresentation RepresentationBuilder::fit(const Representation& representation, const TaskControl& control) {
  if (!fitData_) {
    fitBase_ = fitting::fitBase(subject_.reference, subject_.table);
    fitData_.emplace(*fitBase_.fitted, *fitBase_.measurement, options_.fit);
  }
  const models::Model& model = models::findModel(representation.id);
  const fitting::FitResult result = fitting::fit(*fitData_, model, control);
  control.throwIfStopped();
  return {.brdf = model.instantiate(result.parameters),
          .nodes = nullptr,
          .bytes = fitting::fittedParameterCount(model.spec(), fitData_->symmetry()) * sizeof(float),
          .encodeSeconds = result.seconds,
          .fit = result};
}

BuiltRepresentation RepresentationBuilder::factors(const Representation& representation, const TaskControl& control) {
  using namespace factorization;
  const int terms = int(representation.budget);
  if (pdvOptionsOf(representation, terms).joint) {
    const PdvFactorization joint = factorizePdv(*subject_.table, pdvOptionsOf(representation, terms), control);
    return {.brdf = makePdvBrdf(joint.factors),
            .nodes = nullptr,
            .bytes = formats::pdvFileBytes(joint.factors),
            .encodeSeconds = joint.seconds};
  }
  if (!factorizations_.contains(representation.id)) {
    const int most = std::max(terms, maxTerms_[representation.id]);
    factorizations_[representation.id] = factorizePdv(*subject_.table, pdvOptionsOf(representation, most), control);
  }
  const PdvFactorization& all = factorizations_.at(representation.id);
  if (terms > all.factors.terms())
    throw Error(representation.fullLabel() + ": more terms than the " + std::to_string(all.factors.terms()) +
                " that were computed");
  const PdvFactors factors = all.factors.truncated(terms);
  return {.brdf = makePdvBrdf(factors),
          .nodes = nullptr,
          .bytes = formats::pdvFileBytes(factors),
          .encodeSeconds = all.termSeconds[std::size_t(terms)]};
}

BuiltRepresentation RepresentationBuilder::code(const Representation& representation, const TaskControl& control) {
  if (!encoder_) {
    if (!options_.dictionary) options_.dictionary = materials::bundledEnsemble();
    encoder_.emplace(options_.dictionary->ensemble);
    codedTable_ = onGrid(subject_.table, options_.dictionary->ensemble.grid, {.stop = control.stop});
  }
  const dictionary::EncodeResult encoded = encoder_->encode(*codedTable_, encodeOptionsOf(representation), control);
  const std::vector<std::byte> file = formats::encodeCode(encoded.code, options_.dictionary->id);
  // Of what the file holds: with the values as they are rounded.
  const dictionary::SparseCode stored = formats::readCode(io::MemorySource(file)).code;
  const dictionary::Ensemble& ensemble = options_.dictionary->ensemble;
  const bool sameNodes = subject_.table->grid() == ensemble.grid;
  BuiltRepresentation built{.brdf = dictionary::makeCodeBrdf(ensemble, stored),
                            .nodes = sameNodes ? dictionary::decode(ensemble, stored) : nullptr,
                            .bytes = file.size(),
                            .encodeSeconds = encoded.seconds};
  if (sameNodes)
    built.tabulated = [dictionary = options_.dictionary, stored](const TaskControl&) {
      return dictionary::decode(dictionary->ensemble, stored);
    };
  return built;
}

BuiltRepresentation RepresentationBuilder::components(const Representation& representation,
                                                      const TaskControl& control) const {
  if (!options_.components) throw Error("principal components: none were learned, expected a training set");
  return fromComponents(*options_.components, representation, *subject_.table, control);
}

BuiltRepresentation RepresentationBuilder::separated(const Representation& representation,
                                                     const TaskControl& control) const {
  if (!options_.separated) throw Error("diffuse and specular components: none were learned, expected a training set");
  return fromComponents(*options_.separated, representation, *subject_.table, control);
}

BuiltRepresentation RepresentationBuilder::patches(const Representation& representation,
                                                   const TaskControl& control) const {
  if (!options_.patches) throw Error("codes of patches: no dictionary was learned, expected a training set");
  const auto start = Clock::now();
  const auto code = dictionary::encode(*options_.patches, *subject_.table, std::size_t(representation.budget), control);
  const double seconds = secondsSince(start);
  const auto decoded = dictionary::decode(*options_.patches, code);
  return {.brdf = decoded,
          .nodes = decoded,
          .bytes = dictionary::packChannels(code, dictionary::CodePrecision::quantised).size(),
          .encodeSeconds = seconds,
          .tabulated = [decoded](const TaskControl&) { return decoded; }};
}

BuiltRepresentation RepresentationBuilder::nonparametric(const TaskControl& control) const {
  using namespace factorization;
  const auto start = Clock::now();
  const NonparametricFit fit =
      fitNonparametric(sampleHalfDifference(*subject_.table, nonparametricAxes(), {.stop = control.stop}), {}, control);
  return {.brdf = makeNonparametricBrdf(fit.factors),
          .nodes = nullptr,
          .bytes = NonparametricFactors::bytes(),
          .encodeSeconds = secondsSince(start)};
}

/// Its fit was not measured here: the time is unknown.
BuiltRepresentation RepresentationBuilder::publishedNonparametric() const {
  using namespace factorization;
  if (!options_.publishedNonparametric)
    throw Error("published non-parametric factors: there are none of this material, expected a row of the table");
  return {.brdf = makeNonparametricBrdf(*options_.publishedNonparametric),
          .nodes = nullptr,
          .bytes = NonparametricFactors::bytes(),
          .encodeSeconds = std::numeric_limits<double>::quiet_NaN()};
}

BuiltRepresentation RepresentationBuilder::neuralBrdf(const TaskControl& control) const {
  const neural::NeuralFit fit = neural::fitNeural(*subject_.table, options_.neural, control);
  return {.brdf = std::make_shared<const NeuralBrdf>(fit.weights),
          .nodes = nullptr,
          .bytes = formats::neuralFileBytes,
          .encodeSeconds = fit.seconds};
}

/// Builds each budget separately, so that its time is measured; only the sampling could be shared.
BuiltRepresentation RepresentationBuilder::baseline(const Representation& representation,
                                                    const TaskControl& control) const {
  const auto start = Clock::now();
  const std::array<std::size_t, 1> budgets{std::size_t(representation.budget)};
  const factorization::ComparedModel model =
      findStudiedBaseline(representation.id).build(*subject_.table, budgets, control).front();
  return {.brdf = model.brdf, .nodes = nullptr, .bytes = model.bytes, .encodeSeconds = secondsSince(start)};
}

}  // namespace gonio::study
