// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFramebufferObject>
#include <array>

#include "widgets/preview/gl/preview_display.h"
#include "widgets/preview/gl/preview_renderer.h"

namespace gonio::widgets {

class KnownPicture;

/// Removes noise from a picture with few samples, for display only: measurements, rendered images and difference images
/// are never filtered. Preserves edges of shapes and differences larger than the noise
/// (shaders/preview/noise_filter.frag). A picture without noise does not change, except for rounding. All calls need
/// the picture's context.
class NoiseFilter {
 public:
  /// Seven or eight passes over the picture, which take as long as about two samples of a sphere.
  /// @param known if not null: filters the change from the material of this picture, and adds it to the known picture.
  /// `picture` must have the samples and the size of the last KnownPicture::drawBefore(); the result has the size of
  /// the known one.
  void apply(QOpenGLFunctions_4_1_Core& gl, PreviewResources& resources, const PreviewRenderer& picture,
             const KnownPicture* known = nullptr);
  /// The filtered picture; nothing before apply().
  ShownPicture shown() const;
  /// Gives the buffer of the filtered picture away, after apply() without a known picture.
  std::unique_ptr<QOpenGLFramebufferObject> takeBuffer() { return std::move(targets_[0]); }
  void release();

 private:
  std::unique_ptr<QOpenGLFramebufferObject> prepared_, changed_;
  std::array<std::unique_ptr<QOpenGLFramebufferObject>, 2> targets_;
};

}  // namespace gonio::widgets
