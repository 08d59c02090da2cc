// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>

#include "core/math/types.h"

namespace gonio::widgets {

/// The mean of a picture's opaque pixels, in linear light, as CIE L*, a*, b*; black if there are none.
Rgb meanLab(const QImage& picture);

/// Dissimilarity of two materials by their thumbnails: the Euclidean norm of the colour difference (CIE 1976 delta E)
/// and 10 per octave of roughness. 0: equal.
double dissimilarity(const Rgb& lab, double roughness, const Rgb& otherLab, double otherRoughness);

}  // namespace gonio::widgets
