// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>

#include "core/math/types.h"

namespace gonio::widgets {

/// The mean of a picture's opaque pixels, taken in linear light, as CIE L*, a*, b*. Black of a picture without any.
Rgb meanLab(const QImage& picture);

/// How unlike two materials look, by their thumbnails: the root of the squares of the difference of the mean colours
/// (CIE 1976 delta E) and of 10 for each octave of roughness. 0: the same.
double dissimilarity(const Rgb& lab, double roughness, const Rgb& otherLab, double otherRoughness);

}  // namespace gonio::widgets
