// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <utility>

#include "core/export/export_target.h"
#include "core/export/reciprocal_lobes.h"

namespace gonio::exports {

/// The lobes by a target's own formula with the smallest of some counts that reaches the SNR, else the best; measured,
/// without files. @throws Cancelled.
std::pair<MadeExport, ReciprocalLobes> makeLobesExport(std::span<const std::size_t> counts, LobesFormula formula,
                                                       const ExportSource& source, const ExportOptions& options,
                                                       const TaskControl& control);

}  // namespace gonio::exports
