// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

#include "core/math/types.h"
#include "core/models/parameter_spec.h"

namespace gonio::study {
struct UseCost;
}

/// Display texts of parameters, generated from their specs, and of measured times.
namespace gonio::widgets {

/// The QString of UTF-8 text.
QString toQString(std::string_view text);
/// Display of roughness parameters: as the models define them (alpha), or as the square root, the roughness of other
/// programs (Burley 2012). Does not change the values.
enum class RoughnessDisplay { alpha, squareRoot };
/// A setting of the whole program; call ParameterPanel::showUnits() afterwards.
void setRoughnessDisplay(RoughnessDisplay display);

/// The displayed number is displayFactor() * value^displayPower() in displayUnit(); angles are in degrees.
double displayFactor(const models::ParameterSpec& spec);
double displayPower(const models::ParameterSpec& spec);
QString displayUnit(const models::ParameterSpec& spec);
/// "0.3", "12.5 °", "0.2, 0.4, 0.6" or the name of a choice.
QString displayValue(const models::ParameterSpec& spec, const Rgb& value);
/// Rich text: name and symbol, sentence, formula, unit and range, default, fitted value, source.
QString parameterToolTip(const models::ParameterSpec& spec, const Rgb* fitted);
QString groupTitle(models::ParameterGroup group);

/// "1.2 ms".
QString secondsText(double seconds);
/// "52 ns per evaluation, 14 ms per frame".
QString timesText(const study::UseCost& cost);

}  // namespace gonio::widgets
