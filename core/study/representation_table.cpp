// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
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
#include "core/study/representation_builder.h"

namespace gonio::study {

namespace {

using Built = BuiltRepresentation;
using Context = BuildContext;
using plots::Marker;
using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// Tables.

Built trilinearTable(Context& context, const Representation&, const TaskControl&) {
  const auto table = context.subject.table;
  return {.brdf = table, .nodes = table, .bytes = table->bytes(), .tabulated = [table](const TaskControl&) {
            return table;
          }};
}

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

Built cellTable(Context& context, const Representation& representation, const TaskControl& control) {
  Built built = trilinearTable(context, representation, control);
  built.brdf = std::make_shared<const CellLookupBrdf>(context.subject.table);
  return built;
}

// Fits.

Built fittedModel(Context& context, const Representation& representation, const TaskControl& control) {
  if (!context.fitData) {
    context.fitBase = fitting::fitBase(context.subject.reference, context.subject.table);
    context.fitData.emplace(*context.fitBase.fitted, *context.fitBase.measurement, context.options.fit);
  }
  const models::Model& model = *representation.kind->model;
  const fitting::FitResult result = fitting::fit(*context.fitData, model, control);
  control.throwIfStopped();
  return {.brdf = model.instantiate(result.parameters),
          .nodes = nullptr,
          .bytes = fitting::fittedParameterCount(model.spec(), context.fitData->symmetry()) * sizeof(float),
          .encodeSeconds = result.seconds,
          .fit = result};
}

// PDV factors.

using factorization::PdvForm;
using factorization::PdvOptions;

Built builtFactors(const factorization::PdvFactors& factors, double seconds) {
  return {.brdf = makePdvBrdf(factors),
          .nodes = nullptr,
          .bytes = formats::pdvFileBytes(factors),
          .encodeSeconds = seconds};
}

PdvOptions separateTerms(PdvForm form, int terms) { return {.form = form, .terms = terms}; }

/// The first terms of one factorisation into the planned number of terms. The published ones describe the mean of both
/// orders of the directions, as that of a MERL file.
template <PdvForm form, PdvOptions (*optionsOf)(PdvForm, int)>
Built truncatedFactors(Context& context, const Representation& representation, const TaskControl& control) {
  const RepresentationKind* kind = representation.kind;
  const int terms = int(representation.budget);
  if (!context.factorizations.contains(kind)) {
    const int most = std::max(terms, int(context.maxBudgets[kind]));
    const bool isPublished = optionsOf == factorization::publishedPdvOptions;
    context.factorizations[kind] =
        factorizePdv(isPublished ? *context.mean() : *context.subject.table, optionsOf(form, most), control);
  }
  const factorization::PdvFactorization& all = context.factorizations.at(kind);
  if (terms > all.factors.terms())
    throw Error(representation.fullLabel() + ": more terms than the " + std::to_string(all.factors.terms()) +
                " that were computed");
  return builtFactors(all.factors.truncated(terms), all.termSeconds[std::size_t(terms)]);
}

PdvOptions jointTerms(PdvForm form, int terms) { return {.form = form, .terms = terms, .joint = true}; }
PdvOptions compactTerms(PdvForm form, int terms) { return compactPdvOptions(jointTerms(form, terms)); }

/// Fitted anew for each number of terms.
template <PdvForm form, PdvOptions (*optionsOf)(PdvForm, int)>
Built jointFactors(Context& context, const Representation& representation, const TaskControl& control) {
  const auto joint = factorizePdv(*context.subject.table, optionsOf(form, int(representation.budget)), control);
  return builtFactors(joint.factors, joint.seconds);
}

// Codes.

dictionary::EncodeOptions greedyCode(std::size_t coefficients) { return {.coefficients = coefficients}; }
dictionary::EncodeOptions basisPursuitCode(std::size_t coefficients) {
  return {.coefficients = coefficients, .method = dictionary::CodingMethod::basisPursuit};
}

template <dictionary::EncodeOptions (*optionsOf)(std::size_t)>
Built sparseCode(Context& context, const Representation& representation, const TaskControl& control) {
  BuildOptions& options = context.options;
  if (!context.encoder) {
    if (!options.dictionary) options.dictionary = materials::bundledEnsemble();
    context.encoder.emplace(options.dictionary->ensemble);
    context.codedTable =
        dictionary::onCodeGrid(context.subject.table, options.dictionary->ensemble, {control.stop, {}});
  }
  // As published: of the mean of both orders of the directions, as that of a MERL file.
  const bool isPublished = optionsOf == dictionary::publishedEncodeOptions;
  const auto table = isPublished ? meanOfOrders(context.codedTable) : context.codedTable;
  dictionary::EncodeOptions encoding = optionsOf(std::size_t(representation.budget));
  encoding.quantised = true;
  const dictionary::EncodeResult encoded = context.encoder->encode(*table, encoding, control);
  const std::vector<std::byte> file = formats::encodeCode(encoded.code, options.dictionary->id);
  // Of what the file holds: with the values as they are rounded.
  const dictionary::SparseCode stored = formats::readCode(io::MemorySource(file)).code;
  const dictionary::Ensemble& ensemble = options.dictionary->ensemble;
  const bool sameNodes = context.subject.table->grid() == stored.grid;
  Built built{.brdf = dictionary::makeCodeBrdf(ensemble, stored),
              .nodes = sameNodes ? dictionary::decode(ensemble, stored) : nullptr,
              .bytes = file.size(),
              .encodeSeconds = encoded.seconds};
  if (sameNodes)
    built.tabulated = [dictionary = options.dictionary, stored](const TaskControl&) {
      return dictionary::decode(dictionary->ensemble, stored);
    };
  return built;
}

// What is decoded to a table.

Built decodedTable(const std::shared_ptr<const TabulatedBrdf>& decoded, std::size_t bytes, double seconds) {
  return {.brdf = decoded,
          .nodes = decoded,
          .bytes = bytes,
          .encodeSeconds = seconds,
          .tabulated = [decoded](const TaskControl&) { return decoded; }};
}

std::size_t halfBytesOf(const dictionary::ComponentCode& code) {
  return dictionary::ComponentCode::halfBytes(code.components());
}
std::size_t halfBytesOf(const dictionary::SeparatedCode& code) { return code.halfBytes(); }

/// The material by the first components of a basis, as a file in half precision restores it.
/// @tparam basis which basis: BuildOptions::components or separated.
template <auto basis>
Built components(Context& context, const Representation& representation, const TaskControl& control) {
  const auto& given = context.options.*basis;
  if (!given) throw Error(representation.label() + ": none were learned, expected a training set");
  const int count = int(representation.budget);
  if (count > given->count())
    throw Error(representation.fullLabel() + ": the training set has only " + std::to_string(given->count()) +
                " principal components");
  const auto start = Clock::now();
  const auto encoded = dictionary::encode(*given, *context.mean(), count, control);
  const double seconds = secondsSince(start);
  const auto decoded = dictionary::decode(*given, encoded.inHalfPrecision(), {.stop = control.stop, .progress = {}});
  return decodedTable(decoded, halfBytesOf(encoded), seconds);
}

Built codeOfPatches(Context& context, const Representation& representation, const TaskControl& control) {
  const auto& patches = context.options.patches;
  if (!patches) throw Error(representation.label() + ": no dictionary was learned, expected a training set");
  const auto start = Clock::now();
  const auto code = dictionary::encode(*patches, *context.mean(), std::size_t(representation.budget), control);
  const double seconds = secondsSince(start);
  return decodedTable(dictionary::decode(*patches, code),
                      dictionary::packChannels(code, dictionary::CodePrecision::quantised).size(), seconds);
}

// Non-parametric factors, networks, baselines.

Built builtNonparametric(const factorization::NonparametricFactors& factors, double seconds) {
  return {.brdf = makeNonparametricBrdf(factors),
          .nodes = nullptr,
          .bytes = factorization::NonparametricFactors::bytes(),
          .encodeSeconds = seconds};
}

Built nonparametricFactors(Context& context, const Representation&, const TaskControl& control) {
  using namespace factorization;
  const auto start = Clock::now();
  const auto samples =
      sampleHalfDifference(*context.mean(), nonparametricAxes(), {.stop = control.stop, .progress = {}});
  const NonparametricFit fit = fitNonparametric(samples, {}, control);
  return builtNonparametric(fit.factors, secondsSince(start));
}

/// Their fit was not measured here: the time is unknown.
Built publishedNonparametricFactors(Context& context, const Representation&, const TaskControl&) {
  const auto& factors = context.options.publishedNonparametric;
  if (!factors)
    throw Error("published non-parametric factors: there are none of this material, expected a row of the table");
  return builtNonparametric(*factors, std::numeric_limits<double>::quiet_NaN());
}

Built neuralNetwork(Context& context, const Representation&, const TaskControl& control) {
  const baselines::NeuralFit fit = baselines::fitNeural(*context.mean(), context.options.neural, control);
  return {.brdf = std::make_shared<const NeuralBrdf>(fit.weights),
          .nodes = nullptr,
          .bytes = formats::neuralFileBytes,
          .encodeSeconds = fit.seconds};
}

/// Builds each budget separately, so that its time is measured; only the sampling could be shared.
Built baselineModel(Context& context, const Representation& representation, const TaskControl& control) {
  const auto start = Clock::now();
  const std::array<std::size_t, 1> budgets{std::size_t(representation.budget)};
  const baselines::ComparedModel model =
      representation.kind->baseline->build(*context.mean(), budgets, control).front();
  return {.brdf = model.brdf, .nodes = nullptr, .bytes = model.bytes, .encodeSeconds = secondsSince(start)};
}

// The table. Colours that the colour-blind can distinguish (Okabe and Ito 2008, "Color Universal Design").

namespace family {
constexpr RepresentationFamily table{"table", "measured table", "Look-up in the measured table", "#000000", true};
constexpr RepresentationFamily fits{"fits", "parametric fit", "Fitted parametric models", "#0072b2", true};
constexpr RepresentationFamily factors{"factors", "PDV factors", "Factors of the projected deviation vector", "#d55e00",
                                       true};
constexpr RepresentationFamily codes{"codes", "sparse code", "Sparse codes over the bundled dictionaries", "#009e73",
                                     true};
constexpr RepresentationFamily principal{"components", "principal components", "Principal components of a training set",
                                         "#cc79a7"};
constexpr RepresentationFamily patches{"patches", "code of patches",
                                       "Codes of patches over a dictionary learned by K-SVD", "#44aa99"};
constexpr RepresentationFamily nonparametric{"nonparametric", "non-parametric factors",
                                             "A microfacet model with tabulated factors (Bagher et al. 2016)",
                                             "#e69f00", true};
constexpr RepresentationFamily publishedNonparametric{"published-nonparametric", "published non-parametric factors",
                                                      "The factors that Bagher et al. 2016 published", "#999933"};
constexpr RepresentationFamily baselines{
    "baselines", "baselines", "Other factorisations from the literature, limited to the file sizes of the PDV factors",
    "#56b4e9"};
constexpr RepresentationFamily published{"published", "as published",
                                         "PDV factors and sparse codes as the papers describe them", "#882255"};
constexpr RepresentationFamily alternatives{
    "alternatives", "alternative fits of factors and codes",
    "PDV factors with jointly fitted terms, over all nodes or compact; sparse codes by basis pursuit", "#117733"};
constexpr RepresentationFamily networks{
    "neural", "neural BRDF", "Networks of 675 weights (Sztrajman et al. 2021); training takes about 12 seconds",
    "#332288"};

}  // namespace family

constexpr const RepresentationFamily* families[] = {
    &family::table,     &family::fits,      &family::factors,       &family::codes,
    &family::principal, &family::patches,   &family::nonparametric, &family::publishedNonparametric,
    &family::baselines, &family::published, &family::alternatives,  &family::networks};

constexpr int maxTerms = factorization::maxPdvTerms;

/// Rows of the models and baselines, which come from their registries, are added after those of the families before.
constexpr RepresentationKind rows[] = {
    {.id = "table-cell",
     .label = "Table, cell look-up",
     .family = &family::table,
     .style = {Marker::square, true},
     .build = cellTable,
     .formerId = "table-nearest"},
    {.id = "table-trilinear",
     .label = "Table, trilinear",
     .family = &family::table,
     .style = {Marker::square},
     .build = trilinearTable},
    {.id = "factors-2d",
     .label = "PDV factors, two curves",
     .family = &family::factors,
     .style = {Marker::triangle, true},
     .build = truncatedFactors<PdvForm::twoFactors, separateTerms>,
     .unit = BudgetUnit::terms,
     .maxBudget = maxTerms},
    {.id = "factors-3d",
     .label = "PDV factors, three curves",
     .family = &family::factors,
     .style = {Marker::triangle},
     .build = truncatedFactors<PdvForm::threeFactors, separateTerms>,
     .unit = BudgetUnit::terms,
     .maxBudget = maxTerms},
    {.id = "code",
     .label = "Sparse code",
     .family = &family::codes,
     .style = {Marker::diamond},
     .build = sparseCode<greedyCode>,
     .unit = BudgetUnit::coefficients,
     .maxBudget = maxCodeCoefficients,
     .use = RepresentationUse::showCode},
    {.id = "components",
     .label = "Principal components",
     .family = &family::principal,
     .style = {Marker::cross},
     .build = components<&BuildOptions::components>,
     .unit = BudgetUnit::components,
     .needsFurtherData = true},
    {.id = "components-separated",
     .label = "Diffuse and specular components",
     .family = &family::principal,
     .style = {Marker::threeStar},
     .build = components<&BuildOptions::separated>,
     .unit = BudgetUnit::components,
     .needsFurtherData = true,
     .isOptional = true},
    {.id = "patches",
     .label = "Code of patches, K-SVD",
     .family = &family::patches,
     .style = {Marker::hourglass, true},
     .build = codeOfPatches,
     .unit = BudgetUnit::coefficients,
     .needsFurtherData = true},
    {.id = "nonparametric",
     .label = "Non-parametric factors",
     .family = &family::nonparametric,
     .style = {Marker::star},
     .build = nonparametricFactors},
    {.id = "published-nonparametric",
     .label = "Non-parametric factors, published",
     .family = &family::publishedNonparametric,
     .style = {Marker::hourglass},
     .build = publishedNonparametricFactors,
     .needsFurtherData = true},
    {.id = "factors-2d-published",
     .label = "PDV factors, two curves, as published",
     .family = &family::published,
     .style = {Marker::pentagon, true},
     .build = truncatedFactors<PdvForm::twoFactors, factorization::publishedPdvOptions>,
     .unit = BudgetUnit::terms,
     .maxBudget = maxTerms},
    {.id = "factors-3d-published",
     .label = "PDV factors, three curves, as published",
     .family = &family::published,
     .style = {Marker::pentagon},
     .build = truncatedFactors<PdvForm::threeFactors, factorization::publishedPdvOptions>,
     .unit = BudgetUnit::terms,
     .maxBudget = maxTerms},
    {.id = "code-published",
     .label = "Sparse code, as published",
     .family = &family::published,
     .style = {Marker::triangleLeft},
     .build = sparseCode<dictionary::publishedEncodeOptions>,
     .unit = BudgetUnit::coefficients,
     .maxBudget = maxCodeCoefficients},
    {.id = "factors-2d-joint",
     .label = "PDV factors, two curves, joint fit",
     .family = &family::alternatives,
     .style = {Marker::triangleRight, true},
     .build = jointFactors<PdvForm::twoFactors, jointTerms>,
     .unit = BudgetUnit::terms,
     .maxBudget = maxTerms},
    {.id = "factors-3d-joint",
     .label = "PDV factors, three curves, joint fit",
     .family = &family::alternatives,
     .style = {Marker::triangleRight},
     .build = jointFactors<PdvForm::threeFactors, jointTerms>,
     .unit = BudgetUnit::terms,
     .maxBudget = maxTerms},
    {.id = "factors-3d-compact",
     .label = "PDV factors, three curves, joint fit, compact",
     .family = &family::alternatives,
     .style = {Marker::arrowhead},
     .build = jointFactors<PdvForm::threeFactors, compactTerms>,
     .unit = BudgetUnit::terms,
     .maxBudget = maxTerms},
    {.id = "code-basis-pursuit",
     .label = "Sparse code by basis pursuit",
     .family = &family::alternatives,
     .style = {Marker::triangleLeft, true},
     .build = sparseCode<basisPursuitCode>,
     .unit = BudgetUnit::coefficients,
     .maxBudget = maxCodeCoefficients},
    {.id = "neural",
     .label = "Neural BRDF",
     .family = &family::networks,
     .style = {Marker::fourStar},
     .build = neuralNetwork}};

RepresentationKind rowOf(const models::Model& model) {
  return {.id = model.spec().id,
          .label = model.spec().name,
          .family = &family::fits,
          .style = {Marker::circle},
          .build = fittedModel,
          .unit = BudgetUnit::numbers,
          .legend = "Parametric fit",
          .use = RepresentationUse::editModel,
          .model = &model};
}

/// Shapes of the baselines in their order; no other row has them.
constexpr PointStyle baselineStyles[] = {
    {Marker::circle, true},       {Marker::saltire, false}, {Marker::triangleDown, false}, {Marker::diamond, true},
    {Marker::triangleDown, true}, {Marker::cross, true},    {Marker::star, true},          {Marker::threeStar, true},
    {Marker::saltire, true},      {Marker::fourStar, true}, {Marker::arrowhead, true}};

RepresentationKind rowOf(const baselines::Baseline& baseline, std::size_t index) {
  const bool hasBudget = baseline.maxBytes > 0;
  return {.id = baseline.id,
          .label = baseline.label,
          .family = &family::baselines,
          .style = baselineStyles[index % std::size(baselineStyles)],
          .build = baselineModel,
          .unit = hasBudget ? BudgetUnit::bytes : BudgetUnit::none,
          .maxBudget = hasBudget ? maxBaselineBytes : 0,
          .baseline = &baseline};
}

std::vector<RepresentationKind> wholeTable() {
  std::vector<RepresentationKind> kinds(std::begin(rows), std::end(rows));
  for (const models::Model* model : models::allModels()) kinds.push_back(rowOf(*model));
  std::size_t count = 0;
  for (const baselines::Baseline& baseline : baselines::allBaselines())
    if (!std::ranges::count(rows, baseline.id, &RepresentationKind::id)) kinds.push_back(rowOf(baseline, count++));
  std::ranges::stable_sort(kinds, {}, [](const RepresentationKind& kind) {
    return std::ranges::find(families, kind.family) - std::begin(families);
  });
  return kinds;
}

}  // namespace

std::span<const RepresentationFamily* const> representationFamilies() { return families; }

std::span<const RepresentationKind> representationKinds() {
  static const std::vector<RepresentationKind> kinds = wholeTable();
  return kinds;
}

RepresentationBuilder::RepresentationBuilder(StudySubject subject, BuildOptions options,
                                             std::span<const Representation> planned) {
  context_.subject = std::move(subject);
  context_.options = std::move(options);
  for (const Representation& one : planned) {
    double& most = context_.maxBudgets[one.kind];
    most = std::max(most, one.budget);
  }
}

BuiltRepresentation RepresentationBuilder::build(const Representation& representation, const TaskControl& control) {
  BuiltRepresentation built = representation.kind->build(context_, representation, control);
  if (!built.tabulated)
    built.tabulated = [brdf = built.brdf, grid = context_.subject.table->grid()](const TaskControl& baking) {
      return bakeTable(*brdf, grid, baking);
    };
  return built;
}

}  // namespace gonio::study
