// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <glm/mat3x3.hpp>
#include <vector>

#include "core/models/model.h"

/// A few controls that mean the same for every model and material. Most act on the parameters of a model by what these
/// mean in it (models::ParameterRole), after whatever else changes them, so that each can be moved and reset alone.
/// Tint and saturation act on the edited values themselves: colours that the fit does not explain change too.
namespace gonio::editing {

/// Indices of artistControls().
enum class ArtistControl { roughness, specularStrength, tint, saturation, contrast, coatStrength, edgeBrightness };

/// The controls in the form of a model's parameters: ranges, defaults, texts. At its default each changes nothing.
const models::ModelSpec& artistControls();

/// Whether a control changes the edited values rather than parameters of the model.
bool actsOnValues(ArtistControl control);
/// What tint t and saturation s make of an edited value v: C v with C = (s I + (1 - s) 1 Y^T) diag(t), Y the weights of
/// luminance(). The identity matrix, bit for bit, where both are at their defaults.
glm::dmat3 colourMatrix(const models::ParameterValues& controls);

/// Whether a model has the parameters that a control changes; true of those that act on values.
bool actsOn(ArtistControl control, const models::ModelSpec& model);

/// Parameters with the controls applied, in the order of the list, and cut to their hard ranges; the same parameters,
/// bit for bit, where all controls are at their defaults. O(parameters).
models::ParameterValues withControls(const models::ModelSpec& model, models::ParameterValues parameters,
                                     const models::ParameterValues& controls);

/// What one control does to one parameter.
struct ControlledParameter {
  std::size_t parameter;
  Rgb before, after;
};
/// What a control changes, those before it applied; nothing of lobes that are off, nothing where it acts on values. For
/// a line beside its slider.
std::vector<ControlledParameter> changesBy(ArtistControl control, const models::ModelSpec& model,
                                           const models::ParameterValues& parameters,
                                           const models::ParameterValues& controls);

}  // namespace gonio::editing
