// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <string_view>

namespace gonio::widgets {

/// A formula of a spec (plain text: "alpha_x^2 <= sqrt(1 - |Dp|^2)") as rich text with Greek letters, raised exponents
/// and lowered indices.
QString formulaHtml(std::string_view formula);

/// The formula of a metric and its source.
QString metricToolTip(std::string_view formula, std::string_view reference);

}  // namespace gonio::widgets
