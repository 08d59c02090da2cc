// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/editing/factor_edit.h"

namespace gonio::editing {

/// Transfers an edit of factor curves to another material with the curves `target`:
/// - F1: the ratio at each angle, term by term, so that "10 % stronger" remains 10 % stronger;
/// - F2: the curve of the target is stretched by the ratio of the half-width after the edit to that before it, term by
///   term; the rest of the change is added to the first term, as a function of |Dp| in units of the half-width;
/// - F3: the difference, for the first term.
/// Terms that the edit removed are removed. If `target` equals edit.original, returns the edit itself. preserveDetail
/// is copied. @throws Error if form or transform differ, or either side has no curves.
FactorEdit transferredEdit(const FactorEdit& edit, const FactorEdit::Curves& target);

}  // namespace gonio::editing
