// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

#include "core/documents/blend_source.h"
#include "widgets/preview/gl/preview_subject.h"

namespace gonio::widgets {

/// Materials ready to be blended in one space, for the preview and for pictures. Immutable.
struct PreparedBlend {
  editing::InterpolationSpace space;
  std::vector<editing::InterpolationEnd> ends;
  std::vector<std::shared_ptr<const TabulatedLobe>> lobes;  ///< of the materials
  const models::Model* model = nullptr;                     ///< of `parameters` and `differential`
  std::shared_ptr<const editing::Interpolation> interpolation;
  /// What the shader mixes, in spaces where it mixes tables.
  std::shared_ptr<const editing::TransformedMixture> mixture;
};
using PreparedBlendPtr = std::shared_ptr<const PreparedBlend>;

/// Fits, factorises and encodes what the space needs: up to some seconds. @throws Error, Cancelled.
PreparedBlendPtr prepareBlend(editing::InterpolationSpace space, const std::vector<editing::InterpolationEnd>& ends,
                              const editing::InterpolationOptions& options = editing::blendOptions(),
                              const TaskControl& control = {});

/// Whether materials are mixed of which the shader mixes tables (at least in part), while files and rendered pictures
/// mix them in their own form.
bool mixesTables(const PreparedBlend& blend);

/// What the preview shows at the weights, by what costs least in a frame: `linear`, `dictionary` and `differential` are
/// mixed in the shader, `parameters` are those of a model, `factors` are curves, and a material alone is itself.
PreviewSubject blendSubject(const PreparedBlend& blend, const std::vector<double>& weights);

/// "Linear"; and what it means, for tool tips.
QString spaceName(editing::InterpolationSpace space);
QString spaceExplanation(editing::InterpolationSpace space);

}  // namespace gonio::widgets
