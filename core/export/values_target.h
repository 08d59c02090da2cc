// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_target.h"

namespace gonio::exports {

/// NAME_values.csv: the parameters of the materials of Unreal Engine, Unity (HDRP) and Arnold.
ExportTarget valuesTarget();

}  // namespace gonio::exports
