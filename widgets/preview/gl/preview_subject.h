// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <variant>

#include "core/brdf/tabulated_brdf.h"
#include "core/editing/edit.h"
#include "core/interpolation/interpolation.h"
#include "core/sampling/tabulated_density.h"
#include "widgets/preview/gl/code_decoder.h"

namespace gonio::widgets {

/// A base that the shader can evaluate, with or without edits.
struct EditedMaterial {
  std::shared_ptr<const Brdf> base;  ///< never null; isShownNatively() (widgets/preview/gl/shader_base.h)
  editing::EditList edits = {};
  std::shared_ptr<const EnsembleCode> code = {};  ///< the code from which a table was decoded, or null
};

/// A model without a base.
struct StandaloneModel {
  const models::Model* model = nullptr;
  models::ParameterValues parameters = {};
  HalfDifferenceGrid grid = {};  ///< grid of its table, if one is needed
};

/// Materials mixed by the shader: the result of `interpolation` at the weights, from tables except for `own`. With
/// preserved detail (Interpolation::preservesDetail()), the change of the space is added to the mixture: that of
/// `edits`, of `curves` or of `codes`, whichever is not empty.
struct PreviewBlend {
  std::shared_ptr<const interpolation::Interpolation> interpolation;
  /// The mixture of `interpolation`; with preserved detail the tables of the materials. The same object while the
  /// weights change, so it is uploaded once. At most four materials.
  std::shared_ptr<const interpolation::TransformedMixture> mixture;
  std::vector<double> weights;
  /// One edit per material, applied before mixing, all with the same edited parameters; may be empty.
  std::vector<editing::DifferentialEdit> edits = {};
  /// The material of the largest weight in its native form (an RGL or UTIA file without edits), which replaces the
  /// table for the fraction `ownFraction` of the weight: the difference between the largest and the second largest
  /// weight. Thus the transition between materials is continuous, and at weight 1 no table is used.
  std::shared_ptr<const Brdf> own = {};
  std::size_t ownIndex = 0;
  double ownFraction = 0;
  /// With preserved detail of codes: the mixture of `interpolation`, on one grid with `mixture`; else null.
  std::shared_ptr<const interpolation::TransformedMixture> codes = {};
  /// With preserved detail of factors: the blended curves, then those of the materials; else empty.
  std::vector<editing::FactorEdit::Curves> curves = {};
  /// Whether the change is the mean of both orders of the directions: if it is not reciprocal, but all materials are.
  bool bothOrders = false;

  bool preservesDetail() const { return interpolation->preservesDetail(); }
};

/// The content of a picture; empty by default.
struct PreviewSubject {
  std::variant<std::monostate, EditedMaterial, StandaloneModel, PreviewBlend> shown = {};
  std::shared_ptr<const TabulatedDensity> density = {};  ///< density of the reflected samples; null: not known yet

  bool isEmpty() const { return std::holds_alternative<std::monostate>(shown); }
  /// The base; null if there is none.
  std::shared_ptr<const Brdf> base() const;
  /// Whether it is a base without edits that have an effect, or empty.
  bool isMeasured() const;
};

/// A base without edits; empty if `base` is null.
PreviewSubject measuredSubject(std::shared_ptr<const Brdf> base, std::shared_ptr<const TabulatedDensity> density = {});

/// Whether two subjects have the same base and equal values, so that their images are equal; may be false for equal
/// images.
bool sameSubject(const PreviewSubject& a, const PreviewSubject& b);

/// The BRDF of a subject, for core/rendering and metrics. Null if the subject is empty.
std::shared_ptr<const Brdf> subjectBrdf(const PreviewSubject& subject);

}  // namespace gonio::widgets
