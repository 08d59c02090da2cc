// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFramebufferObject>
#include <array>

#include "widgets/preview/gl/preview_display.h"
#include "widgets/preview/gl/preview_renderer.h"

namespace gonio::widgets {

class NoiseFilter;

/// A picture with many samples of a material as it was before its last changes. While a user moves a slider on a slow
/// device, a frame has few samples at a low resolution. If the earlier material is drawn with the same random numbers,
/// the difference of both has little noise, and the edges of shapes remain sharp: the known picture is a control
/// variate (Owen 2013, "Monte Carlo theory, methods and examples", section 8.9). All calls need the picture's context.
class KnownPicture {
 public:
  /// Takes the picture from `renderer`, which restarts. It must have samples.
  /// @param filter what is shown of it; null: the picture itself.
  void keep(PreviewRenderer& renderer, NoiseFilter* filter);
  void release();

  bool isKept() const { return picture_ != nullptr; }
  /// Whether the known picture is one of the same base, model or blend, and of this size.
  bool serves(const PreviewSubject& changed, const QSize& size) const;

  /// Draws the earlier material as `renderer` is going to draw its own, which restarts, at `size` with `samples`. Costs
  /// nothing if it was drawn so before.
  void drawBefore(PreviewRenderer& renderer, const QSize& size, int samples);

  /// The earlier material as drawn by drawBefore().
  GLuint beforeTexture() const { return before_ ? before_->texture() : 0; }
  /// The known picture, and the sums of its normals (Film::features).
  ShownPicture shown() const;
  GLuint featureTexture() const { return picture_ ? picture_->textures()[1] : 0; }
  QSize size() const { return picture_ ? picture_->size() : QSize(); }

 private:
  std::unique_ptr<QOpenGLFramebufferObject> picture_, filtered_, before_;
  PreviewSubject subject_;
  int samples_ = 0, samplesBefore_ = 0;
};

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
