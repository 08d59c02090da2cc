// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

#include "core/documents/blend_source.h"
#include "widgets/preview/gl/preview_subject.h"

namespace gonio::widgets {

/// Materials ready to be blended in one space, for the preview and for pictures. Immutable.
struct PreparedBlend {
  interpolation::InterpolationSpace space;
  std::vector<interpolation::InterpolationMaterial> materials;
  std::vector<std::shared_ptr<const TabulatedDensity>> lobes;  ///< sampling densities of the materials
  const models::Model* model = nullptr;                        ///< for `parameters` and `differential`
  std::shared_ptr<const interpolation::Interpolation> interpolation;
  /// The tables that the shader mixes, in spaces where it does and with preserved detail.
  std::shared_ptr<const interpolation::TransformedMixture> mixture;
  // With preserved detail: PreviewBlend::codes, and the curves of the materials.
  std::shared_ptr<const interpolation::TransformedMixture> codes = {};
  std::vector<editing::FactorEdit::Curves> curves = {};
};
using PreparedBlendPtr = std::shared_ptr<const PreparedBlend>;

/// Computes the fits, factors or codes for a space: up to a few seconds. @throws Error, Cancelled.
PreparedBlendPtr prepareBlend(interpolation::InterpolationSpace space,
                              const std::vector<interpolation::InterpolationMaterial>& materials,
                              const interpolation::InterpolationOptions& options = documents::blendOptions(),
                              const TaskControl& control = {});

/// Whether the shader mixes tables, at least one of which was sampled from another native form (such as RGL and UTIA
/// files).
bool mixesTables(const PreparedBlend& blend);

/// The preview's subject for given weights, in the form with the lowest cost per frame: the shader mixes `linear`,
/// `dictionary` and `differential`, and all spaces with preserved detail; otherwise `parameters` gives a model and
/// `factors` curves. A weight of 1 gives the material itself.
PreviewSubject blendSubject(const PreparedBlend& blend, const std::vector<double>& weights);

/// The name of a space, e.g. "Linear"; and its description for tooltips.
QString spaceName(interpolation::InterpolationSpace space);
QString spaceExplanation(interpolation::InterpolationSpace space);

}  // namespace gonio::widgets
