// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "widgets/preview/gl/noise_filter.h"

namespace gonio::widgets {

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
  /// The known picture.
  ShownPicture shown() const;
  QSize size() const { return picture_ ? picture_->size() : QSize(); }

 private:
  std::unique_ptr<QOpenGLFramebufferObject> picture_, filtered_, before_;
  PreviewSubject subject_;
  int samples_ = 0, samplesBefore_ = 0;
};

}  // namespace gonio::widgets
