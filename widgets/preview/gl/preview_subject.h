// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>

#include "core/brdf/sampling_lobe.h"
#include "core/brdf/tabulated_brdf.h"
#include "core/editing/edit.h"
#include "core/editing/interpolation/interpolation.h"
#include "widgets/preview/gl/code_texels.h"

namespace gonio::widgets {

/// Materials that the shader mixes: what `interpolation` gives at the weights.
struct PreviewBlend {
  std::shared_ptr<const editing::Interpolation> interpolation;
  /// Of it, kept while the weights change: uploaded once. Four materials at most.
  std::shared_ptr<const editing::TransformedMixture> mixture;
  std::vector<double> weights;
  std::vector<editing::DifferentialEdit> moves = {};  ///< of each material before it is mixed, to one target; or none
};

/// What a picture shows: a measured table, with or without edits, or a model alone, or a blend of materials.
struct PreviewSubject {
  std::shared_ptr<const TabulatedBrdf> table;          ///< null: nothing, or the model alone
  SamplingLobe lobe;                                   ///< density of the reflected samples
  std::optional<editing::DifferentialEdit> edit = {};  ///< on the table
  std::optional<editing::FactorEdit> factors = {};     ///< on the table, before `edit`
  const models::Model* model = nullptr;                ///< alone: the table and the edit do not count
  models::ParameterValues parameters = {};             ///< of `model`
  std::optional<PreviewBlend> blend = {};              ///< alone: nothing of the above counts but the lobe
  std::shared_ptr<const EnsembleCode> code = {};       ///< that `table` was decoded from, where there is one

  bool isEmpty() const { return !table && !model && !blend; }
  bool hasActiveEdit() const { return !isAlone() && edit && !edit->isIdentity(); }
  bool hasActiveFactors() const { return !isAlone() && factors && !factors->isIdentity(); }
  /// Whether it is the table as it is.
  bool isMeasured() const { return !isAlone() && !hasActiveEdit() && !hasActiveFactors(); }
  /// Whether it needs no table of its own.
  bool isAlone() const { return model || blend; }
  std::vector<editing::Edit> edits() const { return editing::editStack(factors, edit); }
};

/// Whether two subjects look the same for certain: equal values on the same table.
bool sameSubject(const PreviewSubject& a, const PreviewSubject& b);

/// The same as a function: what core/rendering draws for comparison, what metrics judge. Null when it is empty.
std::shared_ptr<const Brdf> subjectBrdf(const PreviewSubject& subject);

}  // namespace gonio::widgets
