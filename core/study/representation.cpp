// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/representation.h"

#include <algorithm>
#include <cmath>

#include "core/factorization/pdv_factors.h"
#include "core/fitting/fit_parameters.h"
#include "core/formats/pdv.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::study {

namespace {

struct UnitText {
  std::string_view one, all;  ///< "term"; "coefficients per channel"
};
constexpr UnitText unitTexts[] = {{"", ""},
                                  {"number", "numbers"},
                                  {"term", "terms"},
                                  {"coefficient", "coefficients per channel"},
                                  {"component", "components per channel"},
                                  {"byte", "bytes"}};
const UnitText& textOf(BudgetUnit unit) { return unitTexts[std::size_t(unit)]; }

template <typename Items, typename Name>
std::string listOf(const Items& items, const Name& name) {
  std::string list;
  for (const auto& item : items)
    if (const std::string_view text = name(item); !text.empty()) list += (list.empty() ? "" : ", ") + std::string(text);
  return list;
}

template <typename Counts>
std::vector<double> numbersOf(const Counts& counts) {
  return {counts.begin(), counts.end()};
}

std::vector<double> bytesOf(const std::vector<int>& terms, const baselines::Baseline& baseline) {
  std::vector<double> budgets;
  for (const int count : terms)
    if (budgets.empty() || budgets.back() < double(baseline.maxBytes))
      budgets.push_back(double(formats::pdvFileBytes(factorization::PdvForm::threeFactors, count)));
  return budgets;
}

std::vector<double> budgetsOf(const RepresentationKind& kind, const RepresentationChoice& choice) {
  switch (kind.unit) {
    case BudgetUnit::terms:
      return numbersOf(choice.terms);
    case BudgetUnit::coefficients:
      return numbersOf(choice.coefficients);
    case BudgetUnit::components:
      return numbersOf(choice.components);
    case BudgetUnit::bytes:
      return bytesOf(choice.terms, *kind.baseline);
    case BudgetUnit::numbers:
      return {double(fitting::fittedParameterCount(kind.model->spec()))};
    case BudgetUnit::none:
      break;
  }
  return {0};
}

void checkName(const std::string& name) {
  const auto families = representationFamilies();
  if (std::ranges::count(families, name, &RepresentationFamily::id) || findRepresentationKind(name)) return;
  throw Error("found the kind of representation '" + name + "', expected one of " +
              listOf(families, [](const RepresentationFamily* family) { return family->id; }) +
              " or the id of a representation, such as factors-3d or ggx");
}

}  // namespace

const RepresentationKind* findRepresentationKind(std::string_view id) {
  const auto kinds = representationKinds();
  const auto found = std::ranges::find_if(
      kinds, [&](const RepresentationKind& kind) { return kind.id == id || (!id.empty() && kind.formerId == id); });
  return found == kinds.end() ? nullptr : &*found;
}

std::string Representation::budgetText() const {
  if (kind->unit == BudgetUnit::none) return {};
  const std::string count = std::to_string(std::llround(budget));
  if (kind->unit == BudgetUnit::bytes) return "up to " + count + " bytes";
  return count + " " + std::string(textOf(kind->unit).one) + (budget == 1 ? "" : "s");
}

std::string Representation::fullLabel() const {
  const std::string text = budgetText();
  return text.empty() ? label() : label() + ", " + text;
}

std::string Representation::shortLabel() const { return kind->hasBudget() ? fullLabel() : label(); }

std::vector<std::string> defaultFamilies() {
  std::vector<std::string> ids;
  for (const RepresentationFamily* family : representationFamilies())
    if (family->isDefault) ids.emplace_back(family->id);
  return ids;
}

bool RepresentationChoice::selects(const RepresentationKind& kind) const {
  return std::ranges::any_of(names, [&](const std::string& name) {
    if (name == kind.id || (!name.empty() && name == kind.formerId)) return true;
    return !kind.isOptional && name == kind.family->id;
  });
}

void RepresentationChoice::restrict(std::string_view family, std::span<const std::string> ids) {
  if (ids.empty()) return;
  for (const std::string& id : ids)
    if (const RepresentationKind* kind = findRepresentationKind(id); !kind || kind->family->id != family)
      throw Error("found '" + id + "', expected one of " +
                  listOf(representationKinds(), [&](const RepresentationKind& one) {
                    return one.family->id == family ? one.id : std::string_view();
                  }));
  if (std::erase(names, family) > 0) names.insert(names.end(), ids.begin(), ids.end());
}

std::vector<Representation> representationsOf(const RepresentationChoice& choice) {
  for (const std::string& name : choice.names) checkName(name);
  std::vector<Representation> list;
  for (const RepresentationKind& kind : representationKinds())
    if (choice.selects(kind))
      for (const double budget : budgetsOf(kind, choice)) list.push_back({&kind, budget});
  return list;
}

std::vector<std::string> familiesWithoutFurtherData() {
  std::vector<std::string> ids;
  for (const RepresentationKind& kind : representationKinds())
    if (!kind.needsFurtherData && (ids.empty() || ids.back() != kind.family->id)) ids.emplace_back(kind.family->id);
  return ids;
}

Representation representationById(std::string_view id, std::optional<double> budget) {
  const RepresentationKind* kind = findRepresentationKind(id);
  if (!kind || kind->needsFurtherData)
    throw Error("found the representation '" + std::string(id) + "', expected one of " +
                listOf(representationKinds(),
                       [](const RepresentationKind& one) {
                         return one.model || one.needsFurtherData ? std::string_view() : one.id;
                       }) +
                " or the id of a model, such as ggx");
  if (!kind->hasBudget()) return {kind, budgetsOf(*kind, {}).front()};
  if (!budget || !(*budget >= 1 && *budget <= kind->maxBudget) || *budget != std::floor(*budget))
    throw Error("found the representation '" + std::string(id) + "' with " +
                (budget ? "the budget " + numberText(*budget) : "no budget") + ", expected a whole number from 1 to " +
                std::to_string(kind->maxBudget) + " (" + std::string(textOf(kind->unit).all) + ")");
  return {kind, *budget};
}

}  // namespace gonio::study
