// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/edit_list.h"

#include <algorithm>
#include <cmath>

namespace gonio::editing {

namespace {

bool holdsCurves(const EditList& list, const FactorEdit::Curves& curves) {
  return std::any_of(list.begin(), list.end(), [&](const Edit& edit) {
    const auto* factors = std::get_if<FactorEdit>(&edit.content);
    return factors && (factors->original == curves || factors->edited == curves);
  });
}

std::size_t ownBytes(const DifferentialEdit& edit, const EditList&) {
  return (edit.fitted.values.size() + edit.edited.values.size() + edit.controls.values.size()) * sizeof(Rgb);
}

std::size_t ownBytes(const FactorEdit& edit, const EditList& other) {
  std::size_t sum = 0;
  for (const FactorEdit::Curves& curves : {edit.original, edit.edited})
    if (!holdsCurves(other, curves)) sum += bytesOf(curves);
  return sum;
}

}  // namespace

EditList withParameter(EditList edits, std::size_t index, std::size_t parameter, const Rgb& value) {
  return withEdit(std::move(edits), index,
                  [&](Edit& edit) { std::get<DifferentialEdit>(edit.content).edited.values[parameter] = value; });
}

EditList inserted(EditList edits, std::size_t position, Edit edit) {
  assert(position <= edits.size());
  edits.insert(edits.begin() + std::ptrdiff_t(position), std::move(edit));
  return edits;
}

EditList removed(EditList edits, std::size_t index) {
  assert(index < edits.size());
  edits.erase(edits.begin() + std::ptrdiff_t(index));
  return edits;
}

EditList moved(EditList edits, std::size_t from, std::size_t to) {
  Edit edit = edits[from];
  return inserted(removed(std::move(edits), from), to, std::move(edit));
}

std::size_t unsharedBytes(const EditList& list, const EditList& other) {
  std::size_t sum = 0;
  for (const Edit& edit : list)
    sum += sizeof(edit) + edit.name.size() +
           std::visit([&](const auto& content) { return ownBytes(content, other); }, edit.content);
  return sum;
}

namespace {

using models::ParameterRole;

/// Smaller changes have no word of their own: natural logarithm of the ratio, and of that between channels.
constexpr double minChange = 0.02, minHue = 0.02;
constexpr std::size_t maxWords = 2;

/// Natural logarithms of after / before; 0 where one of them is not positive.
Rgb logRatio(const Rgb& before, const Rgb& after) {
  Rgb result(0);
  for (int c = 0; c < 3; ++c)
    if (before[c] > 0 && after[c] > 0) result[c] = std::log(after[c] / before[c]);
  return result;
}

/// How an edit changes widths, strengths and colours: sums over the parameters of each kind.
struct Changes {
  double width = 0, highlight = 0, diffuse = 0;
  bool coloured = false;
};

Changes changesOf(const DifferentialEdit& edit) {
  Changes changes;
  const models::ParameterValues target = edit.target();
  const auto& parameters = edit.model->spec().parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Rgb ratio = logRatio(edit.fitted.values[i], target.values[i]);
    const double mean = (ratio.r + ratio.g + ratio.b) / 3;
    const double spread = std::max({ratio.r, ratio.g, ratio.b}) - std::min({ratio.r, ratio.g, ratio.b});
    switch (parameters[i].role) {
      case ParameterRole::width:
        changes.width += mean;
        continue;
      case ParameterRole::sharpness:
        changes.width -= mean;
        continue;
      case ParameterRole::diffuse:
        changes.diffuse += mean;
        break;
      case ParameterRole::highlight:
      case ParameterRole::peak:
      case ParameterRole::coat:
      case ParameterRole::normalReflectance:
        changes.highlight += mean;
        break;
      default:
        break;
    }
    changes.coloured |= spread > minHue;
  }
  changes.coloured |= edit.changesColours();
  return changes;
}

std::string wordsOf(const DifferentialEdit& edit) {
  const Changes changes = changesOf(edit);
  std::vector<std::string> words;
  if (std::abs(changes.width) > minChange) words.emplace_back(changes.width > 0 ? "rougher" : "smoother");
  if (changes.coloured) words.emplace_back("recoloured");
  if (std::abs(changes.highlight) > minChange)
    words.emplace_back(changes.highlight > 0 ? "stronger highlight" : "weaker highlight");
  if (std::abs(changes.diffuse) > minChange) words.emplace_back(changes.diffuse > 0 ? "lighter" : "darker");
  if (words.empty()) return "edited";
  std::string text = words.front();
  for (std::size_t i = 1; i < std::min(words.size(), maxWords); ++i) text += ", " + words[i];
  return text;
}

}  // namespace

std::string editSummary(std::span<const Edit> edits) {
  std::string text;
  for (const Edit& edit : edits) {
    if (edit.isIdentity()) continue;
    const auto* change = std::get_if<DifferentialEdit>(&edit.content);
    const std::string words = !edit.name.empty() ? edit.name : change ? wordsOf(*change) : "curves edited";
    if (text == words || text.ends_with(", " + words)) continue;
    text += (text.empty() ? "" : ", ") + words;
  }
  return text;
}

std::string editedName(const std::string& material, std::span<const Edit> edits) {
  const std::string words = editSummary(edits);
  std::string name = words.empty() ? material : material + ", " + words;
  std::ranges::replace_if(
      name, [](char c) { return c == '/' || c == '\\' || c == ':'; }, '_');
  return name;
}

}  // namespace gonio::editing
