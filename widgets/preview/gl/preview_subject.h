// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <variant>

#include "core/brdf/tabulated_brdf.h"
#include "core/brdf/tabulated_lobe.h"
#include "core/editing/edit.h"
#include "core/interpolation/interpolation.h"
#include "widgets/preview/gl/code_texels.h"

namespace gonio::widgets {

/// A measurement in its own form, with or without edits: one that the shader knows.
struct EditedMaterial {
  std::shared_ptr<const Brdf> base;  ///< never null; isShownNatively() (widgets/preview/gl/shader_base.h)
  editing::EditList edits = {};
  std::shared_ptr<const EnsembleCode> code = {};  ///< that a table was decoded from, where there is one
};

/// A model without a measurement.
struct ModelAlone {
  const models::Model* model = nullptr;
  models::ParameterValues parameters = {};
  HalfDifferenceGrid grid = {};  ///< of the table that stands for it where one is needed
};

/// Materials that the shader mixes: what `interpolation` gives at the weights, of all but `own` by tables.
struct PreviewBlend {
  std::shared_ptr<const editing::Interpolation> interpolation;
  /// Of it, kept while the weights change: uploaded once. Four materials at most.
  std::shared_ptr<const editing::TransformedMixture> mixture;
  std::vector<double> weights;
  std::vector<editing::DifferentialEdit> moves = {};  ///< of each material before it is mixed, to one target; or none
  /// The material of the largest weight in its own form (an RGL or UTIA file without edits), which takes `ownShare` of
  /// its weight: what it is ahead of the second, so that a change of place is no step, and all of it at weight 1.
  std::shared_ptr<const Brdf> own = {};
  std::size_t ownIndex = 0;
  double ownShare = 0;
};

/// What a picture shows; nothing at first.
struct PreviewSubject {
  std::variant<std::monostate, EditedMaterial, ModelAlone, PreviewBlend> shown = {};
  std::shared_ptr<const TabulatedLobe> lobe = {};  ///< density of the reflected samples; null: not known yet

  bool isEmpty() const { return std::holds_alternative<std::monostate>(shown); }
  /// Null where no measurement is shown.
  std::shared_ptr<const Brdf> base() const;
  /// Whether it is a measurement as it is, without edits that change something; or nothing.
  bool isMeasured() const;
};

/// A measurement without edits; null: nothing.
PreviewSubject measuredSubject(std::shared_ptr<const Brdf> base, std::shared_ptr<const TabulatedLobe> lobe = {});

/// Whether two subjects look the same for certain: equal values over the same measurement.
bool sameSubject(const PreviewSubject& a, const PreviewSubject& b);

/// The same as a function: what core/rendering draws for comparison, what metrics judge. Null when it is empty.
std::shared_ptr<const Brdf> subjectBrdf(const PreviewSubject& subject);

/// The same as a table: of a model alone on its grid, of a blend as the interpolation has it. Null when it is empty.
/// @throws Cancelled.
std::shared_ptr<const TabulatedBrdf> subjectTable(const PreviewSubject& subject, const TaskControl& control = {});

}  // namespace gonio::widgets
