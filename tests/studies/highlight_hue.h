// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/image.h"

namespace gonio {

/// Mean hue difference (CIE 1976 Delta H*ab, CIELAB units under D65) over the brightest twentieth of the reference's
/// pixels that show something; white is the brightest of them. Pictures of linear RGB, of one size.
double highlightHueError(const Image& reference, const Image& picture);

}  // namespace gonio
