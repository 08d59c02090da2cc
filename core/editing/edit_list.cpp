// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/edit_list.h"

#include <algorithm>

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

}  // namespace gonio::editing
