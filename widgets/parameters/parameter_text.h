// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

#include "core/math/types.h"
#include "core/models/parameter_spec.h"

namespace gonio::widgets {

/// Text about parameters for people, made from their specs only.
QString fromView(std::string_view text);
/// How parameters of roughness are shown and typed: as the models define them (the slope scale α), or as their square
/// root, the roughness of other programs (Burley 2012). The values themselves stay.
enum class RoughnessDisplay { alpha, squareRoot };
/// Of the whole program; ParameterPanel::showUnits() follows.
void setRoughnessDisplay(RoughnessDisplay display);
RoughnessDisplay roughnessDisplay();

/// What is shown is displayFactor() * value^displayPower() in displayUnit(); angles are shown in degrees.
double displayFactor(const models::ParameterSpec& spec);
double displayPower(const models::ParameterSpec& spec);
QString displayUnit(const models::ParameterSpec& spec);
/// "0.3", "12.5 deg", "0.2, 0.4, 0.6" or the name of a choice.
QString displayValue(const models::ParameterSpec& spec, const Rgb& value);
/// Rich text: name and symbol, sentence, formula, unit and range, default, fitted value, source.
QString parameterToolTip(const models::ParameterSpec& spec, const Rgb* fitted);
QString groupTitle(models::ParameterGroup group);

}  // namespace gonio::widgets
