// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// What the checks of plausibility mean, for people.
#include <QCoreApplication>
#include <cmath>

#include "widgets/panels/plausibility_badges.h"

namespace gonio::widgets {

namespace {

struct PlausibilityText {
  Q_DECLARE_TR_FUNCTIONS(PlausibilityText)
};
QString number(double value) { return QString::number(value, 'g', 3); }
QString percent(double fraction) { return QStringLiteral("%1 %").arg(number(100 * fraction)); }

struct Text {
  QString word, meaning, worst, remedy;
};

QString where(const metrics::PlausibilityCheck& check) {
  if (!check.at) return {};
  const double o = degrees(polarAngle(check.at->wo));
  if (check.name == "energy") return PlausibilityText::tr("for a viewer at %1°").arg(o, 0, 'f', 0);
  return PlausibilityText::tr("for light at %1°, viewer at %2°, %3° apart in azimuth")
      .arg(degrees(polarAngle(check.at->wi)), 0, 'f', 0)
      .arg(o, 0, 'f', 0)
      .arg(std::abs(degrees(std::remainder(azimuth(check.at->wi) - azimuth(check.at->wo), 2 * pi))), 0, 'f', 0);
}

Text textOf(const metrics::PlausibilityCheck& check) {
  if (check.name == "energy")
    return {PlausibilityText::tr("Energy"),
            PlausibilityText::tr(
                "A surface reflects at most the light that it receives: the directional albedo is at most 1."),
            PlausibilityText::tr("Maximum albedo: %1 (limit %2)").arg(number(check.worst), number(check.limit)),
            PlausibilityText::tr("Lower the specular strength or the diffuse colour, or raise the roughness.")};
  if (check.name == "reciprocity")
    return {
        PlausibilityText::tr("Reciprocity"),
        PlausibilityText::tr("Exchanging light and viewer does not change the BRDF value."),
        PlausibilityText::tr("Maximum difference: %1 of the value (limit %2)")
            .arg(percent(check.worst), percent(check.limit)),
        PlausibilityText::tr("Choose a reciprocal model; the tooltip of each model states whether it is reciprocal. "
                             "Measured RGL and UTIA files are reciprocal only if \"Incident direction\" in the section "
                             "\"Source\" is set to \"Mean of both (reciprocal)\".")};
  if (check.name == "negative")
    return {PlausibilityText::tr("Non-negative"),
            PlausibilityText::tr("BRDF values are at least 0. Where an edit subtracts more than was measured, the "
                                 "image shows black patches."),
            check.worst > 0 ? PlausibilityText::tr("Negative at %1 of the directions; most negative value: %2 1/sr")
                                  .arg(percent(check.fraction), number(-check.worst))
                            : PlausibilityText::tr("No negative values"),
            PlausibilityText::tr("Reduce the edit, or fit a model that explains the measurement better.")};
  if (check.name == "non-finite")
    return {PlausibilityText::tr("Finite"), PlausibilityText::tr("Every BRDF value is a finite number."),
            PlausibilityText::tr("Values that are not finite: %1").arg(check.worst),
            PlausibilityText::tr(
                "This is an error in the program: undo the last change to continue, and please report the error.")};
  return {
      PlausibilityText::tr("Complete"),
      PlausibilityText::tr("Where the table has no data, the image is black or uses the values of neighbouring cells."),
      PlausibilityText::tr("Fraction of directions without data, weighted by both cosines: %1 (limit %2)")
          .arg(percent(check.worst), percent(check.limit)),
      PlausibilityText::tr("Treat angles without data with caution.")};
}

}  // namespace

QString plausibilityWord(const metrics::PlausibilityCheck& check) { return textOf(check).word; }

QString plausibilityText(const metrics::PlausibilityCheck& check) {
  const Text text = textOf(check);
  const bool locate = check.at && (check.worst > 0 || !check.passed);
  const QString worst = locate ? PlausibilityText::tr("%1, %2.").arg(text.worst, where(check))
                               : PlausibilityText::tr("%1.").arg(text.worst);
  return QStringLiteral("<p><b>%1</b> %2</p><p>%3</p>%4")
      .arg(check.passed ? PlausibilityText::tr("Passed.") : PlausibilityText::tr("Failed."),
           text.meaning.toHtmlEscaped(), worst.toHtmlEscaped(),
           check.passed ? QString() : QStringLiteral("<p>%1</p>").arg(text.remedy.toHtmlEscaped()));
}

}  // namespace gonio::widgets
