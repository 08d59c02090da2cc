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

/// A grey material on a small grid.
inline LoadedMaterialPtr greyMaterial() {
  auto loaded = std::make_shared<LoadedMaterial>();
  loaded->material.name = "grey";
  const HalfDifferenceGrid grid{4, 4, 4};
  loaded->base = std::make_shared<TabulatedBrdf>(grid, std::vector<TabulatedBrdf::Value>(grid.size(), glm::vec3(0.2f)),
                                                 std::vector<std::uint8_t>(grid.size(), 1));
  return loaded;
}

/// A model with its default parameters, as if it had been fitted.
inline void adoptDefaultFit(Document& document, const models::Model& model = defaultModel()) {
  fitting::FitResult fit;
  fit.model = &model;
  fit.parameters = models::defaultParameters(model.spec());
  document.adoptFit(fit);
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
