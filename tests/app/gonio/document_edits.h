// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/document/document.h"

namespace gonio::app::test_support {

/// The active edits of a document; null where there is none.
inline const editing::DifferentialEdit* modelEdit(const Document& document) {
  return document.active<editing::DifferentialEdit>();
}
inline const editing::FactorEdit* factorEdit(const Document& document) {
  return document.active<editing::FactorEdit>();
}

/// Puts an edit of factor curves where the panel puts it, in the place of the active one where there is one.
inline void replaceFactors(Document& document, const editing::FactorEdit& edit, const QString& text) {
  editing::EditList edits = document.edits();
  const int active = activeIndex<editing::FactorEdit>(document.state());
  if (active < 0) {
    edits.insert(edits.begin(), {edit});
    return document.replaceEdits(std::move(edits), text, 0);
  }
  edits[std::size_t(active)].content = edit;
  document.replaceEdits(std::move(edits), text);
}

}  // namespace gonio::app::test_support
