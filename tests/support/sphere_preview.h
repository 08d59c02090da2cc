// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "widgets/preview/gl/preview_renderer.h"

namespace gonio::test {

/// Has a renderer draw a scene of one sphere.
inline void showSphere(widgets::PreviewRenderer& renderer, const rendering::Scene& scene) {
  renderer.setScene(scene, widgets::previewPlan(scene, rendering::diffuseMaterial(Rgb(0.5))));
}

}  // namespace gonio::test
