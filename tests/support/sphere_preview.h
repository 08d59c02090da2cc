// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "widgets/preview/gl/preview_renderer.h"

namespace gonio::tests {

/// Has a renderer draw the one sphere.
inline void showSphere(widgets::PreviewRenderer& renderer, const SphereScene& sphere) {
  const Scene scene = sceneOf(sphere);
  renderer.setScene(scene, widgets::previewPlan(scene, diffuseMaterial(Rgb(0.5))));
}

}  // namespace gonio::tests
