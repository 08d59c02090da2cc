// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_target.h"

namespace gonio::exports {

/// NAME_rgb.bsdf and NAME_spec.bsdf by exportRgl(). pbrtTarget() sets RglOptions::bothSides.
ExportTarget mitsubaTarget();
ExportTarget pbrtTarget();

}  // namespace gonio::exports
