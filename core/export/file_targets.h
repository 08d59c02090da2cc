// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_target.h"

/// Targets whose files are materials themselves, made by materials::encode().
namespace gonio::exports {

/// NAME_rgb.bsdf and NAME_spec.bsdf by materials::encodeRgl(). For pbrt, negative values are 0.
ExportTarget mitsubaTarget();
ExportTarget pbrtTarget();
/// NAME.binary: MERL, 90 x 90 x 180, reciprocal and isotropic.
ExportTarget merlTarget();
/// NAME_360.binary: MERL, 90 x 90 x 360, isotropic.
ExportTarget merlCircleTarget();
/// NAME.bin: UTIA, 288 x 288 pairs of directions.
ExportTarget utiaTarget();
/// NAME.csv: BRDF values on a grid of directions.
ExportTarget csvTarget();

}  // namespace gonio::exports
