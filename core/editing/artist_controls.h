// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <glm/mat3x3.hpp>
#include <vector>

#include "core/models/model.h"

/// Controls with the same meaning for every model and material. Most change the parameters of a model according to
/// their roles (models::ParameterRole), after all other changes, so that each control can be moved and reset
/// independently. Tint and saturation change the edited values themselves, so that they also affect colours that the
/// fit does not explain.
namespace gonio::editing {

/// Indices of the parameters of artistControls().
enum class ArtistControl { roughness, specularStrength, tint, saturation, contrast, coatStrength, edgeBrightness };

/// The controls as parameters of a model: ranges, defaults, texts. At its default a control has no effect.
const models::ModelSpec& artistControls();

/// Whether a control changes the edited values rather than parameters of the model.
bool actsOnValues(ArtistControl control);
/// Tint t and saturation s as a matrix C of linear RGB: C = (s I + (1 - s) 1 Y^T) diag(t), Y the weights of
/// luminance(). Exactly the identity if both are at their defaults.
glm::dmat3 colourMatrix(const models::ParameterValues& controls);

/// Whether a model has parameters that a control changes; true for controls that act on values.
bool actsOn(ArtistControl control, const models::ModelSpec& model);

/// Parameters with all controls applied, in the order of the list, and clamped to their hard ranges; exactly the same
/// parameters if all controls are at their defaults. O(parameters).
models::ParameterValues withControls(const models::ModelSpec& model, models::ParameterValues parameters,
                                     const models::ParameterValues& controls);

/// The same with ArtistControl::roughness at its default and the parameters of `fitted` for the widths of highlights.
models::ParameterValues withWidthsOf(const models::ParameterValues& fitted, const models::ModelSpec& model,
                                     models::ParameterValues parameters, models::ParameterValues controls);

/// The effect of one control on one parameter: its value per channel before and after the control.
struct ControlledParameter {
  std::size_t parameter;
  Rgb before, after;
};
/// The parameters that a control changes, if the controls before it in the list are applied first; for the text beside
/// its slider. Parameters of lobes that are switched off are omitted. Empty for controls that act on values.
std::vector<ControlledParameter> changesBy(ArtistControl control, const models::ModelSpec& model,
                                           const models::ParameterValues& parameters,
                                           const models::ParameterValues& controls);

}  // namespace gonio::editing
