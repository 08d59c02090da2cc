// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/parameters/parameter_text.h"

#include <QCoreApplication>
#include <cmath>

#include "core/study/accuracy_study.h"
#include "core/study/study_plot.h"
#include "widgets/inputs/number_field.h"
#include "widgets/parameters/formula_text.h"

namespace gonio::widgets {

namespace {
struct ParameterText {
  Q_DECLARE_TR_FUNCTIONS(ParameterText)
};

RoughnessDisplay chosenRoughness = RoughnessDisplay::alpha;

bool isShownAsRoot(const models::ParameterSpec& spec) {
  return chosenRoughness == RoughnessDisplay::squareRoot && spec.role == models::ParameterRole::width &&
         spec.scale != models::ParameterScale::angle && spec.id.find("roughness") != std::string_view::npos;
}

QString displayNumber(const models::ParameterSpec& spec, double value) {
  return formatNumber(std::pow(value, displayPower(spec)) * displayFactor(spec));
}
}  // namespace

void setRoughnessDisplay(RoughnessDisplay display) { chosenRoughness = display; }

QString toQString(std::string_view text) { return QString::fromUtf8(text.data(), qsizetype(text.size())); }

double displayFactor(const models::ParameterSpec& spec) {
  return spec.scale == models::ParameterScale::angle ? degrees(1.0) : 1.0;
}

double displayPower(const models::ParameterSpec& spec) { return isShownAsRoot(spec) ? 0.5 : 1; }

QString displayUnit(const models::ParameterSpec& spec) {
  return spec.scale == models::ParameterScale::angle ? QStringLiteral("°") : toQString(spec.unit);
}

QString displayValue(const models::ParameterSpec& spec, const Rgb& value) {
  if (!spec.choices.empty()) {
    const auto index = std::size_t(std::lround(std::max(0.0, value.x)));
    return toQString(spec.choices[std::min(index, spec.choices.size() - 1)]);
  }
  const QString unit = displayUnit(spec).isEmpty() ? QString() : QChar(0x202f) + displayUnit(spec);
  if (!spec.perChannel) return displayNumber(spec, value.x) + unit;
  return QStringLiteral("%1, %2, %3")
             .arg(displayNumber(spec, value.x), displayNumber(spec, value.y), displayNumber(spec, value.z)) +
         unit;
}

QString parameterToolTip(const models::ParameterSpec& spec, const Rgb* fitted) {
  const auto line = [](const QString& name, const QString& text) {
    return QStringLiteral("<tr><td style='padding-right:1em'>%1</td><td>%2</td></tr>").arg(name, text.toHtmlEscaped());
  };
  const QString shownAsRoot =
      isShownAsRoot(spec) ? QStringLiteral("<p>%1</p>").arg(ParameterText::tr("The slider shows √α.")) : QString();
  QString text = QStringLiteral("<p><b>%1</b> &nbsp;%2</p><p>%3</p><p>%4</p>%5<table>")
                     .arg(toQString(spec.label).toHtmlEscaped(), formulaHtml(spec.symbol),
                          toQString(spec.description).toHtmlEscaped(), formulaHtml(spec.formula), shownAsRoot);
  if (spec.choices.empty()) {
    const QString unit = displayUnit(spec).isEmpty() ? ParameterText::tr("none") : displayUnit(spec);
    const auto range = [&](double from, double to) {
      return ParameterText::tr("%1 to %2").arg(displayNumber(spec, from), displayNumber(spec, to));
    };
    text += line(ParameterText::tr("Unit"), unit);
    text += line(ParameterText::tr("Slider range"), range(spec.softMin, spec.softMax));
    text += line(ParameterText::tr("Allowed range"), range(spec.hardMin, spec.hardMax));
  }
  text += line(ParameterText::tr("Default"), displayValue(spec, Rgb(spec.defaultValue)));
  if (fitted) text += line(ParameterText::tr("Fitted"), displayValue(spec, *fitted));
  if (!spec.reference.empty()) text += line(ParameterText::tr("Source"), toQString(spec.reference));
  return text + QStringLiteral("</table>");
}

QString groupTitle(models::ParameterGroup group) {
  switch (group) {
    case models::ParameterGroup::diffuse:
      return ParameterText::tr("Diffuse");
    case models::ParameterGroup::specular:
      return ParameterText::tr("Specular");
    case models::ParameterGroup::fresnel:
      return ParameterText::tr("Fresnel");
    case models::ParameterGroup::shadowing:
      return ParameterText::tr("Shadowing");
    case models::ParameterGroup::layer:
      return ParameterText::tr("Layer");
    case models::ParameterGroup::coefficients:
      return ParameterText::tr("Coefficients");
    case models::ParameterGroup::convention:
      return ParameterText::tr("Conventions");
  }
  return {};
}

QString secondsText(double seconds) { return QString::fromStdString(study::shortQuantity(seconds, "s")); }

QString timesText(const study::UseCost& cost) {
  return ParameterText::tr("%1 per evaluation, %2 per frame")
      .arg(secondsText(1e-9 * cost.evaluation.median), secondsText(1e-3 * cost.frameMilliseconds));
}

}  // namespace gonio::widgets
