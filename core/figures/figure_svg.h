// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>

#include "core/figures/figure_drawing.h"

namespace gonio::figures {

/// A drawing as SVG, in mm, with its pictures embedded as PNG and its texts as text.
std::string figureSvg(const FigureDrawing& drawing);

}  // namespace gonio::figures
