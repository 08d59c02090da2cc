// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <qopengl.h>

namespace gonio::widgets {

/// A picture that can be displayed.
struct ShownPicture {
  GLuint texture = 0;  ///< premultiplied linear radiance and coverage, times `samples`; 0: no picture yet
  float samples = 1;
};

}  // namespace gonio::widgets
