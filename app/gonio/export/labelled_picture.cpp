// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/export/labelled_picture.h"

#include "app/gonio/comparison/comparison_controller.h"
#include "app/gonio/comparison/comparison_numbers.h"

namespace gonio::app {

FileExports::Caption comparisonCaption(const ComparisonController& comparison, const QString& material) {
  const auto sides = comparison.sides();
  const QString names =
      ComparisonController::tr("%1, %2 against %3").arg(material, comparison.name(sides[0]), comparison.name(sides[1]));
  return [names, test = comparison.subject(sides[0]),
          reference = comparison.subject(sides[1])](const TaskControl& control) {
    const ComparisonReferencePtr made = comparisonReference(reference, control.between(0, 0.5));
    const ComparisonNumbers numbers = compareSubjects(test, *made, control.between(0.5, 1));
    return ComparisonController::tr("%1: BRDF SNR %2 dB; rendered SNR %3 dB, PSNR %4 dB (comparison scene)")
        .arg(names, comparisonValue(numbers.brdfSnr), comparisonValue(numbers.renderedSnr),
             comparisonValue(numbers.renderedPsnr));
  };
}

}  // namespace gonio::app
