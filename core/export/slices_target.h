// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_target.h"

namespace gonio::exports {

/// Pictures of half-difference space, as BRDF viewers and papers show them.
ExportTarget slicesTarget();

}  // namespace gonio::exports
