// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

#include "core/brdf/data_transform.h"

namespace gonio::app {

/// Formula of a transform, e.g. "ln(1 + ρ)", with the BRDF value ρ in 1/sr.
QString transformFormula(DataTransform transform);

}  // namespace gonio::app
