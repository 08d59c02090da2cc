// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

#include "core/brdf/data_transform.h"

namespace gonio::app {

/// What a transformed reflectance is, as people write it: "ln(1 + ρ)", ρ in 1/sr.
QString transformFormula(DataTransform transform);

}  // namespace gonio::app
