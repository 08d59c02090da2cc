// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/metrics/image_metrics.h"
#include "core/rendering/render_picture.h"
#include "tests/support/sphere_preview.h"
#include "tests/widgets/offscreen_context.h"

namespace gonio::test {

/// Pictures of a sphere by the preview's shader, beside those of the CPU. Tests skip when isValid() is false.
class OffscreenSpheres {
 public:
  static constexpr int side = 32;

  OffscreenSpheres() {
    if (isValid()) renderer_.initialize();
  }
  ~OffscreenSpheres() {
    if (isValid()) renderer_.release();
  }
  bool isValid() const { return context_.isValid(); }
  widgets::PreviewRenderer& renderer() { return renderer_; }

  Image drawn(const widgets::PreviewSubject& subject, const Scene& scene, int samples) {
    renderer_.setSubject(subject);
    showSphere(renderer_, scene);
    renderer_.setSize({side, side});
    for (int i = 0; i < samples / 64; ++i) renderer_.accumulate(64);
    return renderer_.readPicture();
  }

  /// SNR of the shader's picture against that of `brdf` on the CPU, dB: of 64 samples where that is above `enough`,
  /// else of 256 or of 512, which few pictures need. The CPU's noise does not count (metrics::PicturePair), the
  /// shader's does.
  double agreement(const widgets::PreviewSubject& subject, const Brdf& brdf, const Scene& scene, double enough) {
    double snr = 0;
    const auto material = pictureMaterial(brdf, {});
    for (const int samples : {64, 256, 512}) {
      metrics::PicturePair reference;
      for (std::size_t i = 0; i < 2; ++i)
        reference[i] =
            renderPicture(material, scene, {.width = side, .height = side, .samples = samples / 2, .seed = 7 + i});
      const Image shown = drawn(subject, scene, samples);
      snr = metrics::signalToNoiseRatio(reference, {shown, shown});
      if (snr > enough) break;
    }
    return snr;
  }

 private:
  OffscreenContext context_;
  widgets::PreviewRenderer renderer_;
};

}  // namespace gonio::test
