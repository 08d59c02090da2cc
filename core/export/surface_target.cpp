// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/surface_target.h"

#include <cmath>
#include <cstdio>

#include "core/export/export_report.h"

namespace gonio::exports {

SurfaceValues writtenValues(SurfaceValues values) {
  constexpr double noEffect = 1e-3;
  if (values.coat < noEffect) values.coat = 0;
  if (maxChannel(values.sheenColour) < noEffect) values.sheenColour = Rgb(0);
  if (values.anisotropy < noEffect) values.anisotropy = 0;
  values.rotation = values.anisotropy > 0 ? values.rotation - pi * std::floor(values.rotation / pi) : 0;
  return values;
}

ExportResult makeSurfaceExport(const SurfaceShader& shader, std::string_view suffix, SurfaceText text,
                               const materials::EditedMaterial& source, const ExportOptions& options,
                               const TaskControl& control) {
  const RenderedComparison comparison = materials::comparisonOf(source, options, control.between(0, 0.15));
  const SurfaceValues values = writtenValues(fitSurface(shader, *source.shown.brdf, control.between(0.15, 0.85)));
  ExportResult made;
  measureExport(made, shader.brdf(values), comparison, control.between(0.85, 1));
  made.facts = {{"metalness", "Metalness", values.metalness},
                {"roughness", "Roughness", values.roughness},
                {"coat", "Coat", values.coat}};
  if (!source.shown.brdf->isIsotropic() && !shader.isFitted(SurfaceField::anisotropy))
    made.warnings.push_back(meanAzimuthWarning());
  made.parts.push_back(textPart(suffix, text(source, values, originText(source, made.snr))));
  return made;
}

std::string decimalText(double number) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.6g", number + 0.0);  // no "-0"
  return digits;
}

std::string colourText(const Rgb& colour, std::string_view separator) {
  return decimalText(colour.x) + std::string(separator) + decimalText(colour.y) + std::string(separator) +
         decimalText(colour.z);
}

}  // namespace gonio::exports
