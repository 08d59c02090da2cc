// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/dictionary/principal_components.h"

namespace gonio::dictionary {

/// learnPrincipalComponents() with the columns in a temporary file: each block of cells is read twice, for the Gram
/// matrix and for the components. @param first the table of material 0.
PrincipalComponents learnStreamedComponents(
    const TabulatedBrdf& first, std::size_t materials,
    const std::function<std::shared_ptr<const TabulatedBrdf>(std::size_t material)>& load, const PcaOptions& options,
    const TaskControl& control);

}  // namespace gonio::dictionary
