// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/rendering/path_tracer.h"

namespace gonio::rendering {

/// What a plan leaves out of a picture, measured.
struct PlanCheck {
  /// Mean of the picture with all effects less that of the plan, relative to the picture with all effects, and its
  /// standard error. 0 for a black picture.
  double omitted = 0, standardError = 0;
  /// The same for the block of 8 x 8 pixels in which most is missing, relative to the mean of the whole picture.
  double worstBlock = 0, worstStandardError = 0;

  /// Whether more is missing, beyond the noise, than `remainder` of the picture's mean.
  bool findsMore(double remainder) const;
};

/// Renders a small picture by the plan and with all effects that are not forced off, with the same random numbers:
/// about 33,000 paths, some hundredths of a second. @param materials of bindMaterials(), as for the plan. @throws
/// Cancelled.
PlanCheck checkPlan(const Scene& scene, const std::vector<std::shared_ptr<const RenderMaterial>>& materials,
                    const EffectPlan& plan, const EffectOverrides& overrides = {},
                    const EffectThresholds& thresholds = {}, const TaskControl& control = {});

/// The plan of planEffects(), after a check by checkPlan() where it leaves out what could be seen: if the check finds
/// that more is missing than the thresholds allow, interreflection is simulated between all objects, and its reason
/// states what was found. The plan rests on bounds that hold for every
/// direction; the check is for scenes in which the brightest reflection, to which the remainder refers, is outside the
/// picture. @throws Cancelled.
EffectPlan checkedPlan(const Scene& scene, const std::vector<std::shared_ptr<const RenderMaterial>>& materials,
                       const EffectOverrides& overrides = {}, const EffectThresholds& thresholds = {},
                       const TaskControl& control = {});

}  // namespace gonio::rendering
