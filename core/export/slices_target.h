// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_target.h"

namespace gonio::exports {

/// Images of slices of half-difference space, as in BRDF viewers and papers.
ExportTarget slicesTarget();

}  // namespace gonio::exports
