// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// What the checks of plausibility mean, for people.
#include <QCoreApplication>
#include <cmath>

#include "widgets/panels/plausibility_badges.h"

namespace gonio::widgets {

namespace {

struct PlausibilityTextText {
  Q_DECLARE_TR_FUNCTIONS(PlausibilityText)
};
QString number(double value) { return QString::number(value, 'g', 3); }
QString percent(double share) { return QStringLiteral("%1 %").arg(number(100 * share)); }

struct Text {
  QString word, meaning, worst, remedy;
};

QString where(const metrics::PlausibilityCheck& check) {
  if (!check.at) return {};
  const double o = degrees(polarAngle(check.at->wo));
  if (check.name == "energy") return PlausibilityTextText::tr("for a viewer at %1°").arg(o, 0, 'f', 0);
  return PlausibilityTextText::tr("for light at %1°, viewer at %2°, %3° apart in azimuth")
      .arg(degrees(polarAngle(check.at->wi)), 0, 'f', 0)
      .arg(o, 0, 'f', 0)
      .arg(std::abs(degrees(std::remainder(azimuth(check.at->wi) - azimuth(check.at->wo), 2 * pi))), 0, 'f', 0);
}

Text textOf(const metrics::PlausibilityCheck& check) {
  if (check.name == "energy")
    return {PlausibilityTextText::tr("Energy"),
            PlausibilityTextText::tr(
                "No surface sends back more light than it receives: the directional albedo is at most 1."),
            PlausibilityTextText::tr("Largest albedo: %1 (limit %2)").arg(number(check.worst), number(check.limit)),
            PlausibilityTextText::tr(
                "Lower the specular scale or the diffuse colour, or raise the roughness at grazing angles.")};
  if (check.name == "reciprocity")
    return {PlausibilityTextText::tr("Reciprocity"),
            PlausibilityTextText::tr("Light takes the same way back: exchanging light and viewer changes nothing."),
            PlausibilityTextText::tr("Largest difference: %1 of the value (limit %2)")
                .arg(percent(check.worst), percent(check.limit)),
            PlausibilityTextText::tr(
                "Models that are not reciprocal by construction say so in their tooltips; choose another one.")};
  if (check.name == "negative")
    return {
        PlausibilityTextText::tr("Negative"),
        PlausibilityTextText::tr(
            "The edit takes away more than was measured there. The picture shows 0 instead: black patches."),
        PlausibilityTextText::tr("Lowest value: %1 1/sr, at %2 of the directions")
            .arg(number(-check.worst), percent(check.share)),
        PlausibilityTextText::tr("Take back part of the edit, or fit a model that explains the measurement better.")};
  if (check.name == "non-finite")
    return {PlausibilityTextText::tr("Finite"), PlausibilityTextText::tr("Every value is a number."),
            PlausibilityTextText::tr("Values that are no numbers: %1").arg(check.worst),
            PlausibilityTextText::tr("Take back the last change and report it: this is a fault of the program.")};
  return {PlausibilityTextText::tr("Measured"),
          PlausibilityTextText::tr(
              "Where the table has no data, the picture is black or takes the values of the cells around."),
          PlausibilityTextText::tr("Share of what is seen without data: %1 (limit %2)")
              .arg(percent(check.worst), percent(check.limit)),
          PlausibilityTextText::tr("Judge those angles with care: nothing was measured there.")};
}

}  // namespace

QString plausibilityWord(const metrics::PlausibilityCheck& check) { return textOf(check).word; }

QString plausibilityText(const metrics::PlausibilityCheck& check) {
  const Text text = textOf(check);
  const bool locate = check.at && (check.worst > 0 || !check.passed);
  const QString worst = locate ? PlausibilityTextText::tr("%1, %2.").arg(text.worst, where(check))
                               : PlausibilityTextText::tr("%1.").arg(text.worst);
  return QStringLiteral("<p><b>%1</b> %2</p><p>%3</p>%4")
      .arg(check.passed ? PlausibilityTextText::tr("Passed.") : PlausibilityTextText::tr("Not plausible."),
           text.meaning.toHtmlEscaped(), worst.toHtmlEscaped(),
           check.passed ? QString() : QStringLiteral("<p>%1</p>").arg(text.remedy.toHtmlEscaped()));
}

}  // namespace gonio::widgets
