// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>

#include "core/figures/figure_drawing.h"

namespace gonio::figures {

/// A drawing as SVG, in mm, with pictures embedded as PNG and texts as text elements.
std::string figureSvg(const FigureDrawing& drawing);

}  // namespace gonio::figures
