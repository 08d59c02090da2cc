// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

namespace gonio::widgets {

/// Message if QOpenGLFunctions_4_1_Core cannot be initialised.
inline constexpr const char* openGlTooOld =
    "the graphics driver does not support OpenGL 4.1 (core profile); update the driver, or start Gonio with the "
    "environment variable LIBGL_ALWAYS_SOFTWARE=1 (software rendering by Mesa)";

}  // namespace gonio::widgets
