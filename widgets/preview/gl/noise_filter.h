// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFramebufferObject>
#include <array>

#include "widgets/preview/gl/preview_renderer.h"
#include "widgets/preview/gl/shown_picture.h"

namespace gonio::widgets {

/// Takes noise out of a picture that has few samples, for the eye alone: what is read and measured is never filtered.
/// Edges of shapes stay, and so do differences that are larger than the noise (shaders/preview/noise_filter.frag). A
/// picture without noise stays as it is but for rounding. Every call needs the picture's context.
class NoiseFilter {
 public:
  /// Six passes over the picture: about as long as two samples of a sphere.
  void apply(QOpenGLFunctions_4_1_Core& gl, PreviewResources& resources, const PreviewRenderer& picture);
  /// The filtered picture; nothing before apply().
  ShownPicture shown() const;
  void release();

 private:
  std::array<std::unique_ptr<QOpenGLFramebufferObject>, 2> targets_;
};

}  // namespace gonio::widgets
