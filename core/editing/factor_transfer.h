// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/editing/factor_edit.h"

namespace gonio::editing {

/// The change that an edit of factor curves makes, carried over to another material, whose curves `target` are:
/// - F1 by ratio at each angle, term by term: "10 % stronger" stays 10 % stronger;
/// - F2 by its width: the target's is stretched as the edit stretched its own (half-width of each term), and what the
///   edit did beside stretching is added to the first term, over |Dp| in units of the half-width;
/// - F3 of the first term by difference.
/// Terms that the edit dropped are dropped. Onto the curves it was made on, the edit itself. Kept detail goes with it.
/// @throws Error when form or transform differ, or either side has no curves.
FactorEdit transferredEdit(const FactorEdit& edit, const FactorEdit::Curves& target);

}  // namespace gonio::editing
