// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/factor_edit.h"

#include <algorithm>
#include <cmath>

#include "core/factorization/pdv_operations.h"
#include "core/support/error.h"

namespace gonio::editing {

namespace {

using factorization::PdvFactors;
using factorization::PdvForm;
using factorization::PdvTerm;

constexpr std::size_t maxCurveNodes = 4096;

nlohmann::json numbersToJson(const std::vector<double>& numbers) {
  for (const double number : numbers)
    if (!std::isfinite(number))
      throw Error("a factor curve that contains a number that is not finite cannot be written");
  return numbers;
}

nlohmann::json factorsToJson(const PdvFactors& f) {
  nlohmann::json channels = nlohmann::json::array();
  for (const std::vector<PdvTerm>& channel : f.channels) {
    nlohmann::json terms = nlohmann::json::array();
    for (const PdvTerm& term : channel)
      terms.push_back({{"f1", numbersToJson(term.f1)}, {"f2", numbersToJson(term.f2)}, {"f3", numbersToJson(term.f3)}});
    channels.push_back(std::move(terms));
  }
  nlohmann::json json{{"form", f.form == PdvForm::twoFactors ? "2d" : "3d"},
                      {"transform", dataTransformNames[std::size_t(f.transform)]},
                      {"highest", numbersToJson({f.highest})[0]},
                      {"thetaNodes", numbersToJson(f.thetaNodes)},
                      {"deviationNodes", numbersToJson(f.deviationNodes)},
                      {"phiNodes", numbersToJson(f.phiNodes)},
                      {"channels", std::move(channels)}};
  if (f.lowest < 0) json["lowest"] = numbersToJson({f.lowest})[0];
  return json;
}

std::vector<double> numbersFromJson(const JsonObject& object, const char* key, std::size_t fewest, std::size_t most) {
  const std::string expected = fewest == most
                                   ? "a list of " + std::to_string(fewest) + " numbers"
                                   : "a list of " + std::to_string(fewest) + " to " + std::to_string(most) + " numbers";
  const nlohmann::json& list = object.array(key);
  if (list.size() < fewest || list.size() > most) object.fail(key, expected);
  std::vector<double> numbers;
  for (const nlohmann::json& entry : list) {
    if (!entry.is_number() || !std::isfinite(entry.get<double>())) object.fail(key, expected);
    numbers.push_back(entry.get<double>());
  }
  return numbers;
}

std::vector<double> nodesFromJson(const JsonObject& object, const char* key, std::size_t fewest, std::size_t most) {
  const std::vector<double> nodes = numbersFromJson(object, key, fewest, most);
  if (nodes.front() != 0 || std::adjacent_find(nodes.begin(), nodes.end(), std::greater_equal<>()) != nodes.end())
    object.fail(key, "strictly increasing numbers that start at 0");
  return nodes;
}

DataTransform transformFromJson(const JsonObject& object) {
  const auto found = dataTransformNamed(object.text("transform"));
  if (!found) object.fail("transform", "one of " + dataTransformList());
  return *found;
}

std::vector<PdvTerm> termsFromJson(const nlohmann::json& json, const PdvFactors& axes, const std::string& where) {
  std::vector<PdvTerm> terms;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const JsonObject term(json[i], where + "[" + std::to_string(i) + "]");
    const auto curve = [&](const char* key, const std::vector<double>& nodes) {
      return numbersFromJson(term, key, nodes.size(), nodes.size());
    };
    terms.push_back({curve("f1", axes.thetaNodes), curve("f2", axes.deviationNodes), curve("f3", axes.phiNodes)});
  }
  return terms;
}

PdvFactors factorsFromJson(const JsonObject& object) {
  PdvFactors f;
  const std::string form = object.text("form");
  if (form != "2d" && form != "3d") object.fail("form", "\"2d\" or \"3d\"");
  const bool flat = form == "2d";
  f.form = flat ? PdvForm::twoFactors : PdvForm::threeFactors;
  f.transform = transformFromJson(object);
  f.highest = object.number("highest", 0, maxBrdfValue);
  if (object.contains("lowest")) f.lowest = object.number("lowest", -maxBrdfValue, 0);
  f.thetaNodes = nodesFromJson(object, "thetaNodes", 2, maxCurveNodes);
  f.deviationNodes = nodesFromJson(object, "deviationNodes", 2, maxCurveNodes);
  f.phiNodes = nodesFromJson(object, "phiNodes", flat ? 1 : 2, flat ? 1 : maxCurveNodes);
  const nlohmann::json& channels = object.array("channels");
  if (channels.size() != 3) object.fail("channels", "a list of 3");
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t terms = channels[c].is_array() ? channels[c].size() : 0;
    if (terms < 1 || terms > std::size_t(factorization::maxPdvTerms) || terms != channels[0].size())
      object.fail("channels", "the same number of terms in each of the three, from 1 to " +
                                  std::to_string(factorization::maxPdvTerms));
    f.channels[c] = termsFromJson(channels[c], f, object.place("channels") + "[" + std::to_string(c) + "]");
  }
  return f;
}

}  // namespace

std::size_t bytesOf(const FactorEdit::Curves& curves) {
  if (!curves) return 0;
  const std::size_t nodes = curves->thetaNodes.size() + curves->deviationNodes.size() + curves->phiNodes.size();
  return sizeof(*curves) + nodes * (1 + 3 * std::size_t(curves->terms())) * sizeof(double);
}

nlohmann::json toJson(const FactorEdit& edit) {
  if (!edit.original || !edit.edited) throw Error("a factor edit without curves cannot be written");
  return {{"type", "factors"},
          {"original", factorsToJson(*edit.original)},
          {"edited", factorsToJson(*edit.edited)},
          {"keepDetail", edit.preserveDetail}};
}

FactorEdit factorEditFromJson(const nlohmann::json& json, const std::string& where) {
  const JsonObject object(json, where);
  FactorEdit edit;
  edit.original = std::make_shared<const PdvFactors>(factorsFromJson(object.object("original")));
  edit.edited = std::make_shared<const PdvFactors>(factorsFromJson(object.object("edited")));
  edit.preserveDetail = object.flag("keepDetail");
  return edit;
}

namespace {

using factorization::PdvFactors;
using factorization::PdvTerm;
using factorization::resampled;
using factorization::widened;
using Curve = std::vector<double>;

/// A ratio is given only where there is something to compare with, and stays within what a hand would do.
constexpr double minFraction = 1e-3, maxRatio = 100;

double largestSize(const Curve& curve) {
  double largest = 0;
  for (const double value : curve) largest = std::max(largest, std::abs(value));
  return largest;
}

/// Where, behind its highest place, a curve has fallen to half of it in size; the last node where it never does.
double halfWidth(const Curve& nodes, const Curve& curve) {
  const auto size = [&](std::size_t i) { return std::abs(curve[i]); };
  std::size_t peak = 0;
  for (std::size_t i = 1; i < curve.size(); ++i)
    if (size(i) > size(peak)) peak = i;
  const double half = size(peak) / 2;
  for (std::size_t i = peak + 1; i < curve.size(); ++i)
    if (size(i) <= half && size(i - 1) > half)
      return nodes[i - 1] + (nodes[i] - nodes[i - 1]) * (size(i - 1) - half) / (size(i - 1) - size(i));
  return nodes.back();
}

Curve ratios(const Curve& from, const Curve& to) {
  const double smallest = minFraction * largestSize(from);
  Curve result(from.size(), 1);
  for (std::size_t i = 0; i < result.size(); ++i)
    if (std::abs(from[i]) > smallest) result[i] = std::clamp(to[i] / from[i], -maxRatio, maxRatio);
  return result;
}

Curve difference(const Curve& to, const Curve& from) {
  Curve result = to;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] -= from[i];
  return result;
}

/// Sums, not below 0: what the first term holds is never negative.
Curve raised(const Curve& curve, const Curve& change) {
  Curve result = curve;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = std::max(0.0, result[i] + change[i]);
  return result;
}

/// One term of one channel of both sides of an edit.
struct Change {
  const PdvTerm &original, &edited;
};

void carryF1(const FactorEdit& edit, const Change& change, const PdvFactors& target, Curve& f1) {
  const Curve& nodes = edit.original->thetaNodes;
  const Curve to = resampled(edit.edited->thetaNodes, change.edited.f1, nodes);
  const Curve factors = resampled(nodes, ratios(change.original.f1, to), target.thetaNodes);
  for (std::size_t i = 0; i < f1.size(); ++i) f1[i] *= factors[i];
}

void carryF2(const FactorEdit& edit, const Change& change, const PdvFactors& target, bool first, Curve& f2) {
  const Curve& nodes = edit.original->deviationNodes;
  const Curve to = resampled(edit.edited->deviationNodes, change.edited.f2, nodes);
  const double width = halfWidth(nodes, change.original.f2), targetWidth = halfWidth(target.deviationNodes, f2);
  const double stretch = width > 0 ? halfWidth(nodes, to) / width : 1;
  if (!(stretch > 0) || !(targetWidth > 0)) return;
  f2 = widened(target.deviationNodes, f2, stretch);
  if (!first) return;
  Curve places = target.deviationNodes;
  for (double& place : places) place *= width / targetWidth;
  f2 = raised(f2, resampled(nodes, difference(to, widened(nodes, change.original.f2, stretch)), places));
}

void carryF3(const FactorEdit& edit, const Change& change, const PdvFactors& target, Curve& f3) {
  if (target.phiNodes.size() < 2) return;
  const Curve& nodes = edit.original->phiNodes;
  const Curve to = resampled(edit.edited->phiNodes, change.edited.f3, nodes);
  f3 = raised(f3, resampled(nodes, difference(to, change.original.f3), target.phiNodes));
}

void checkAlike(const FactorEdit& edit, const FactorEdit::Curves& target) {
  if (!edit.original || !edit.edited || !target) throw Error("a factor edit without curves cannot be transferred");
  for (const FactorEdit::Curves& own : {edit.original, edit.edited})
    if (own->form != target->form || own->transform != target->transform)
      throw Error(
          "the factor edit and the factors of the material differ in the number of curves (2 or 3) or in the "
          "transform, expected the same");
}

}  // namespace

FactorEdit transferredEdit(const FactorEdit& edit, const FactorEdit::Curves& target) {
  checkAlike(edit, target);
  FactorEdit result = edit;
  result.original = target;
  if (*target == *edit.original) return result;
  const bool dropped = edit.edited->terms() < edit.original->terms();
  PdvFactors curves = dropped ? target->truncated(edit.edited->terms()) : *target;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto& originals = edit.original->channels[channel];
    const auto& edits = edit.edited->channels[channel];
    std::vector<PdvTerm>& terms = curves.channels[channel];
    for (std::size_t i = 0; i < std::min({terms.size(), originals.size(), edits.size()}); ++i) {
      const Change change{originals[i], edits[i]};
      carryF1(edit, change, *target, terms[i].f1);
      carryF2(edit, change, *target, i == 0, terms[i].f2);
      if (i == 0) carryF3(edit, change, *target, terms[i].f3);
    }
  }
  result.edited = std::make_shared<const PdvFactors>(factorization::withRoomForEdits(curves));
  return result;
}

}  // namespace gonio::editing
