// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>

#include "core/brdf/brdf.h"
#include "core/math/image.h"
#include "core/support/task_control.h"

namespace gonio::app {

/// A picture of a sphere with any BRDF in the studio environment, on a transparent background, with hue and roughness
/// as text entries of the image.
/// @throws Cancelled.
QImage spherePicture(const Brdf& brdf, int pixels, int samples, const TaskControl& control = {});

/// Converts a rendered picture to display colours with exposure 0 and the filmic tone map.
QImage displayedImage(const Image& picture);

}  // namespace gonio::app
