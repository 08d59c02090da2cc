// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFramebufferObject>
#include <array>

#include "widgets/preview/gl/preview_display.h"
#include "widgets/preview/gl/preview_renderer.h"

namespace gonio::widgets {

/// Removes noise from a picture with few samples, for display only: measurements, rendered images and difference images
/// are never filtered. Preserves edges of shapes and differences larger than the noise
/// (shaders/preview/noise_filter.frag). A picture without noise does not change, except for rounding. All calls need
/// the picture's context.
class NoiseFilter {
 public:
  /// Six or seven passes over the picture, which take as long as about two samples of a sphere.
  void apply(QOpenGLFunctions_4_1_Core& gl, PreviewResources& resources, const PreviewRenderer& picture);
  /// The filtered picture; nothing before apply().
  ShownPicture shown() const;
  void release();

 private:
  std::array<std::unique_ptr<QOpenGLFramebufferObject>, 2> targets_;
};

}  // namespace gonio::widgets
