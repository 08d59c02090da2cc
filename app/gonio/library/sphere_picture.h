// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>

#include "core/brdf/brdf.h"
#include "core/math/image.h"
#include "core/support/task_control.h"

namespace gonio::app {

/// A sphere of any reflectance in the studio, on a transparent ground, with its hue and roughness as texts of the
/// image.
/// @throws Cancelled.
QImage spherePicture(const Brdf& brdf, int pixels, int samples, const TaskControl& control = {});

/// A picture that was rendered, as the screen shows it: exposure 0, the film-like tone curve.
QImage displayedImage(const Image& picture);

}  // namespace gonio::app
