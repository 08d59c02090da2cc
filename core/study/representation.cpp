// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/representation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/factorization/pdv_factors.h"
#include "core/fitting/fit_parameters.h"
#include "core/models/registry.h"
#include "core/support/error.h"
#include "core/support/number_text.h"

namespace gonio::study {

namespace {

struct FamilyRecord {
  std::string_view id, name;
};
constexpr std::array<FamilyRecord, representationFamilyCount> families{{{"table", "measured table"},
                                                                        {"fits", "parametric fit"},
                                                                        {"factors", "PDV factors"},
                                                                        {"codes", "dictionary code"},
                                                                        {"components", "principal components"},
                                                                        {"nonparametric", "non-parametric factors"}}};

using List = std::vector<Representation>;

void addTables(List& list) {
  list.push_back({RepresentationFamily::table, "table-nearest", "Table, nearest cell", 0, ""});
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
      return addCounted(list, {family, "code", "Dictionary code"}, choice.coefficients, "coefficient");
    case RepresentationFamily::components:
      return addCounted(list, {family, "components", "Principal components"}, choice.components, "component");
    case RepresentationFamily::nonparametric:
      list.push_back({family, "nonparametric", "Non-parametric factors", 0, ""});
  }
}

}  // namespace

std::string_view familyId(RepresentationFamily family) { return families[std::size_t(family)].id; }
std::string_view familyName(RepresentationFamily family) { return families[std::size_t(family)].name; }

RepresentationFamily familyById(std::string_view id) {
  const auto found = std::ranges::find(families, id, &FamilyRecord::id);
  if (found != families.end()) return RepresentationFamily(found - families.begin());
  std::string known;
  for (const FamilyRecord& family : families) known += (known.empty() ? "" : ", ") + std::string(family.id);
  throw Error("found the representations '" + std::string(id) + "', expected one of " + known);
}

std::string Representation::fullLabel() const { return budgetText.empty() ? label : label + ", " + budgetText; }

bool needsBudget(std::string_view id) { return id == "factors-2d" || id == "factors-3d" || id == "code"; }

Representation representationById(std::string_view id, std::optional<double> budget) {
  RepresentationChoice choice;
  const double most = id == "code" ? maxCodeCoefficients : factorization::maxPdvTerms;
  if (needsBudget(id)) {
    if (!budget || !(*budget >= 1 && *budget <= most) || *budget != std::floor(*budget))
      throw Error("found the representation '" + std::string(id) + "' with " +
                  (budget ? "the budget " + numberText(*budget) : "no budget") +
                  ", expected a whole number from 1 to " + numberText(most) +
                  (id == "code" ? " (coefficients per channel)" : " (terms)"));
    choice.terms = {int(*budget)};
    choice.coefficients = {std::size_t(*budget)};
  }
  std::string known;
  for (const Representation& one : representationsOf(choice)) {
    if (one.id == id) return one;
    if (one.family != RepresentationFamily::fit) known += (known.empty() ? "" : ", ") + one.id;
  }
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
