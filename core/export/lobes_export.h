// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <utility>

#include "core/export/export_target.h"
#include "core/export/reciprocal_lobes.h"

namespace gonio::exports {

/// Fits lobes for a target's own formula and measures the result, without writing files. @param counts numbers of GGX
/// lobes to try, ascending; the first that reaches options.snr is used, or the one with the highest SNR.
/// @throws Cancelled.
std::pair<ExportResult, ReciprocalLobes> makeLobesExport(std::span<const std::size_t> counts, LobesFormula formula,
                                                         const materials::EditedMaterial& source,
                                                         const ExportOptions& options, const TaskControl& control);

}  // namespace gonio::exports
