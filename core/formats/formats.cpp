// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/formats/formats.h"

namespace gonio::materials {

std::span<const MaterialFormat* const> materialFormats() { return formats::allFormats; }

}  // namespace gonio::materials
