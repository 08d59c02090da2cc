// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/factor_edit.h"

#include <algorithm>
#include <cmath>

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
  return {{"form", f.form == PdvForm::twoFactors ? "2d" : "3d"},
          {"transform", dataTransformNames[std::size_t(f.transform)]},
          {"highest", numbersToJson({f.highest})[0]},
          {"thetaNodes", numbersToJson(f.thetaNodes)},
          {"deviationNodes", numbersToJson(f.deviationNodes)},
          {"phiNodes", numbersToJson(f.phiNodes)},
          {"channels", std::move(channels)}};
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
  const std::string name = object.text("transform");
  const auto found = std::find(dataTransformNames.begin(), dataTransformNames.end(), name);
  if (found == dataTransformNames.end()) object.fail("transform", "log-plus, cosine-log, root or none");
  return static_cast<DataTransform>(found - dataTransformNames.begin());
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
  f.highest = object.number("highest", 0, 1e30);
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

}  // namespace gonio::editing
