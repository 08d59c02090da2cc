// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/representation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/factorization/pdv_factors.h"
#include "core/fitting/fit_parameters.h"
#include "core/formats/pdv.h"
#include "core/models/registry.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::study {

namespace {

struct FamilyRecord {
  std::string_view id, name;
};
constexpr std::array<FamilyRecord, representationFamilyCount> families{
    {{"table", "measured table"},
     {"fits", "parametric fit"},
     {"factors", "PDV factors"},
     {"codes", "sparse code"},
     {"components", "principal components"},
     {"patches", "code of patches"},
     {"nonparametric", "non-parametric factors"},
     {"published-nonparametric", "published non-parametric factors"},
     {"baselines", "baselines"},
     {"published", "as published"},
     {"alternatives", "alternative fits of factors and codes"},
     {"neural", "neural BRDF"}}};

using factorization::Baseline;
using List = std::vector<Representation>;

void addTables(List& list) {
  list.push_back({RepresentationFamily::table, "table-nearest", "Table, cell look-up", 0, ""});
  list.push_back({RepresentationFamily::table, "table-trilinear", "Table, trilinear", 0, ""});
}

void addFits(List& list, std::vector<const models::Model*> models) {
  if (models.empty()) models.assign(models::allModels().begin(), models::allModels().end());
  for (const models::Model* model : models) {
    const models::ModelSpec& spec = model->spec();
    const std::size_t count = fitting::fittedParameterCount(spec);
    list.push_back({RepresentationFamily::fit, std::string(spec.id), std::string(spec.name), double(count),
                    std::to_string(count) + " numbers"});
  }
}

template <typename Count>
void addCounted(List& list, const Representation& of, const std::vector<Count>& counts, const std::string& what) {
  for (const Count count : counts) {
    Representation one = of;
    one.budget = double(count);
    one.budgetText = std::to_string(count) + " " + what + (count == 1 ? "" : "s");
    list.push_back(one);
  }
}

Representation baselineOf(const Baseline& baseline, std::size_t bytes) {
  Representation one{RepresentationFamily::baselines, std::string(baseline.id), std::string(baseline.label), 0, ""};
  if (baseline.maxBytes == 0) return one;
  one.budget = double(bytes);
  one.budgetText = "up to " + std::to_string(bytes) + " bytes";
  return one;
}

/// Adds baselines with the bytes of PDV factors as budgets, as long as a larger budget changes the model.
void addBaselines(List& list, const RepresentationChoice& choice) {
  for (const Baseline* baseline : choice.baselines.empty() ? studiedBaselines() : choice.baselines) {
    std::size_t before = 0;
    for (const int terms : choice.terms) {
      if (before > 0 && before >= baseline->maxBytes) continue;
      before = formats::pdvFileBytes(factorization::PdvForm::threeFactors, terms);
      list.push_back(baselineOf(*baseline, before));
    }
  }
}

void add(List& list, RepresentationFamily family, const RepresentationChoice& choice) {
  switch (family) {
    case RepresentationFamily::table:
      return addTables(list);
    case RepresentationFamily::fit:
      return addFits(list, choice.models);
    case RepresentationFamily::factors:
      addCounted(list, {family, "factors-2d", "PDV factors, two curves"}, choice.terms, "term");
      return addCounted(list, {family, "factors-3d", "PDV factors, three curves"}, choice.terms, "term");
    case RepresentationFamily::code:
      return addCounted(list, {family, "code", "Sparse code"}, choice.coefficients, "coefficient");
    case RepresentationFamily::components:
      addCounted(list, {family, "components", "Principal components"}, choice.components, "component");
      if (choice.separatedComponents)
        addCounted(list, {family, std::string(separatedComponentsId), "Diffuse and specular components"},
                   choice.components, "component");
      return;
    case RepresentationFamily::patches:
      return addCounted(list, {family, "patches", "Code of patches, K-SVD"}, choice.coefficients, "coefficient");
    case RepresentationFamily::nonparametric:
      return list.push_back({family, "nonparametric", "Non-parametric factors", 0, ""});
    case RepresentationFamily::publishedNonparametric:
      return list.push_back({family, "published-nonparametric", "Non-parametric factors, published", 0, ""});
    case RepresentationFamily::baselines:
      return addBaselines(list, choice);
    case RepresentationFamily::published:
      addCounted(list, {family, "factors-2d-published", "PDV factors, two curves, as published"}, choice.terms, "term");
      addCounted(list, {family, "factors-3d-published", "PDV factors, three curves, as published"}, choice.terms,
                 "term");
      return addCounted(list, {family, "code-published", "Sparse code, as published"}, choice.coefficients,
                        "coefficient");
    case RepresentationFamily::alternatives:
      addCounted(list, {family, "factors-2d-joint", "PDV factors, two curves, joint fit"}, choice.terms, "term");
      addCounted(list, {family, "factors-3d-joint", "PDV factors, three curves, joint fit"}, choice.terms, "term");
      addCounted(list, {family, "factors-3d-compact", "PDV factors, three curves, joint fit, compact"}, choice.terms,
                 "term");
      return addCounted(list, {family, "code-basis-pursuit", "Sparse code by basis pursuit"}, choice.coefficients,
                        "coefficient");
    case RepresentationFamily::neural:
      return list.push_back({family, "neural", "Neural BRDF", 0, ""});
  }
}

/// Null if there is none with this id.
const Baseline* studiedBaseline(std::string_view id) {
  const auto all = studiedBaselines();
  const auto found = std::ranges::find(all, id, &Baseline::id);
  return found == all.end() ? nullptr : *found;
}

struct CountedBudget {
  int max = 0;  ///< 0 if there is no budget
  std::string what;
};
CountedBudget budgetOf(std::string_view id) {
  if (id == "code" || id.starts_with("code-")) return {maxCodeCoefficients, "coefficients per channel"};
  if (id.starts_with("factors-2d") || id.starts_with("factors-3d")) return {factorization::maxPdvTerms, "terms"};
  if (const Baseline* baseline = studiedBaseline(id); baseline && baseline->maxBytes > 0)
    return {maxBaselineBytes, "bytes"};
  return {};
}

}  // namespace

std::string_view familyId(RepresentationFamily family) { return families[std::size_t(family)].id; }
std::string_view familyName(RepresentationFamily family) { return families[std::size_t(family)].name; }

RepresentationFamily familyById(std::string_view id) {
  const auto found = std::ranges::find(families, id, &FamilyRecord::id);
  if (found != families.end()) return RepresentationFamily(found - families.begin());
  std::string known;
  for (const FamilyRecord& family : families) known += (known.empty() ? "" : ", ") + std::string(family.id);
  throw Error("found the kind of representation '" + std::string(id) + "', expected one of " + known);
}

std::vector<RepresentationFamily> familiesWithoutFurtherData() {
  std::vector<RepresentationFamily> result;
  for (int i = 0; i < representationFamilyCount; ++i)
    if (const auto family = RepresentationFamily(i); family != RepresentationFamily::components &&
                                                     family != RepresentationFamily::patches &&
                                                     family != RepresentationFamily::publishedNonparametric)
      result.push_back(family);
  return result;
}

std::string Representation::fullLabel() const { return budgetText.empty() ? label : label + ", " + budgetText; }

std::vector<const Baseline*> studiedBaselines() {
  std::vector<const Baseline*> studied;
  for (const Baseline& baseline : factorization::baselines())
    if (baseline.id != familyId(RepresentationFamily::nonparametric)) studied.push_back(&baseline);
  return studied;
}

const Baseline& findStudiedBaseline(std::string_view id) {
  if (const Baseline* baseline = studiedBaseline(id)) return *baseline;
  std::string known;
  for (const Baseline* baseline : studiedBaselines()) known += (known.empty() ? "" : ", ") + std::string(baseline->id);
  throw Error("found the baseline '" + std::string(id) + "', expected one of " + known);
}

int maxBudget(std::string_view id) { return budgetOf(id).max; }
bool needsBudget(std::string_view id) { return maxBudget(id) > 0; }

Representation representationById(std::string_view id, std::optional<double> budget) {
  RepresentationChoice choice;
  choice.families.push_back(RepresentationFamily::published);
  choice.families.push_back(RepresentationFamily::alternatives);
  choice.families.push_back(RepresentationFamily::neural);
  if (const CountedBudget counted = budgetOf(id); counted.max > 0) {
    if (!budget || !(*budget >= 1 && *budget <= counted.max) || *budget != std::floor(*budget))
      throw Error("found the representation '" + std::string(id) + "' with " +
                  (budget ? "the budget " + numberText(*budget) : "no budget") +
                  ", expected a whole number from 1 to " + std::to_string(counted.max) + " (" + counted.what + ")");
    choice.terms = {int(*budget)};
    choice.coefficients = {std::size_t(*budget)};
  }
  if (const Baseline* baseline = studiedBaseline(id)) return baselineOf(*baseline, std::size_t(budget.value_or(0)));
  std::string known, last;
  for (const Representation& one : representationsOf(choice)) {
    if (one.id == id) return one;
    if (one.family == RepresentationFamily::fit || one.id == last) continue;
    known += (known.empty() ? "" : ", ") + one.id;
    last = one.id;
  }
  for (const Baseline* baseline : studiedBaselines()) known += ", " + std::string(baseline->id);
  throw Error("found the representation '" + std::string(id) + "', expected one of " + known +
              " or the id of a model, such as ggx");
}

std::vector<Representation> representationsOf(const RepresentationChoice& choice) {
  List list;
  for (int i = 0; i < representationFamilyCount; ++i)
    if (const auto family = RepresentationFamily(i); std::ranges::count(choice.families, family) > 0)
      add(list, family, choice);
  return list;
}

}  // namespace gonio::study
