// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <optional>

namespace gonio::widgets {

/// The value of a typed number or of simple arithmetic: + - * / ^, parentheses, the constant pi, and decimal points or
/// commas ("0,3*2" is 0.6). A trailing `unit` is ignored. Empty for other texts and for results that are not finite.
std::optional<double> evaluateArithmetic(const QString& text, const QString& unit = {});

}  // namespace gonio::widgets
