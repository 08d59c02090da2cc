// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cassert>
#include <utility>

#include "core/editing/edit.h"

/// New lists of edits from old ones. Indices are those of existing edits. Each copies the list: some kB, curves are
/// shared.
namespace gonio::editing {

/// The list with `change(edit)` done to one edit.
template <class Change>
EditList withEdit(EditList edits, std::size_t index, const Change& change) {
  assert(index < edits.size());
  change(edits[index]);
  return edits;
}

/// @param index of a differential edit.
EditList withParameter(EditList edits, std::size_t index, std::size_t parameter, const Rgb& value);
/// @param position before which the edit is put, at most the size of the list.
EditList inserted(EditList edits, std::size_t position, Edit edit);
EditList removed(EditList edits, std::size_t index);
/// The edit `from` becomes number `to`; those between move by one.
EditList moved(EditList edits, std::size_t from, std::size_t to);

/// Memory of the edits that `list` does not share with `other`: curves that both hold do not count.
std::size_t bytesBeside(const EditList& list, const EditList& other);

}  // namespace gonio::editing
