// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cassert>
#include <string>
#include <utility>

#include "core/editing/edit.h"

/// Functions that return a changed copy of a list of edits. Indices must be those of existing edits. A copy takes a
/// few kB; curves are shared.
namespace gonio::editing {

/// The list with `change(edit)` applied to one edit.
template <class Change>
EditList withEdit(EditList edits, std::size_t index, const Change& change) {
  assert(index < edits.size());
  change(edits[index]);
  return edits;
}

/// The list with one value of DifferentialEdit::edited replaced. @param index of a differential edit.
EditList withParameter(EditList edits, std::size_t index, std::size_t parameter, const Rgb& value);
/// @param position index of the new edit, at most the size of the list.
EditList inserted(EditList edits, std::size_t position, Edit edit);
EditList removed(EditList edits, std::size_t index);
/// Moves the edit `from` to index `to`; those between move by one.
EditList moved(EditList edits, std::size_t from, std::size_t to);

/// Memory of `list` in bytes, without the curves that it shares with `other`.
std::size_t unsharedBytes(const EditList& list, const EditList& other);

/// A short description of the effect of edits, such as "rougher, recoloured": at most two items of one to three words.
/// A name that the user gave to an edit replaces its description. Empty if no edit has an effect.
std::string editSummary(std::span<const Edit> edits);

/// The name of an edited material, such as "gold-paint, rougher"; the material's own name if no edit has an effect.
/// Valid as a file name: without '/', '\\' and ':'.
std::string editedName(const std::string& material, std::span<const Edit> edits);

}  // namespace gonio::editing
