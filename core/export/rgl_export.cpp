// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/rgl_export.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/brdf/rgl_edit.h"
#include "core/export/rgl_description.h"
#include "core/export/rgl_rewrite.h"
#include "core/rendering/rendered_comparison.h"

namespace gonio::exports {

namespace {

std::size_t negativeCount(const SliceStack<glm::vec3>& rgb) {
  std::size_t count = 0;
  for (const glm::vec3& value : rgb.values) count += (value.x < 0) + (value.y < 0) + (value.z < 0);
  return count;
}

double snrOf(const Brdf& file, const Brdf& material, const RglOptions& options, const TaskControl& control) {
  RenderOptions pictures;
  pictures.width = pictures.height = options.pictureSize;
  pictures.samples = options.samples;
  const RenderedComparison comparison(material, pictures, control.between(0, 0.5));
  return comparison.signalToNoiseRatio(comparison.render(file, control.between(0.5, 1)));
}

RglExport exportParameterised(const ExportSource& source, const RglOptions& options, const TaskControl& control) {
  RglParameterisation made = parameterise(*source.brdf, options, control);
  const std::string description = describe(source.origin, made.snr, made.clipped);
  RglExport result;
  result.rgb = io::encodeTensorFile(rglFields(made.data, description, RglColours::rgb));
  result.spectral = io::encodeTensorFile(rglFields(made.data, description, RglColours::spectra));
  result.size = made.size;
  result.snr = made.snr;
  result.clippedValues = made.clipped;
  result.brdf = std::make_shared<const RglBrdf>(std::move(made.data));
  return result;
}

RglExport exportEdited(const ExportSource& source, const RglOptions& options, const TaskControl& control) {
  const auto file = source.rgl->withIncident(IncidentDirection::viewer);
  const EditedRgl edited = editedColours(*file, *source.brdf, control.between(0, 0.2));
  RglExport result;
  result.unchanged = !edited.changed;
  result.clippedValues = edited.clipped;
  result.negativeValues = negativeCount(edited.rgb);
  result.size = {file->tables()->data.incident.thetas().size(), edited.rgb.width};
  const RglRewrite rewrite(source.rglFile, file->tables(), edited);
  result.brdf = edited.changed ? std::make_shared<const RglBrdf>(rewrite.data()) : file;
  result.snr = edited.changed ? snrOf(*result.brdf, *source.brdf, options, control.between(0.2, 1))
                              : std::numeric_limits<double>::infinity();
  const std::string description = describe(source.origin, result.snr, edited.clipped);
  result.rgb = rewrite.bytes(RglColours::rgb, description);
  result.spectral = rewrite.bytes(RglColours::spectra, description);
  return result;
}

}  // namespace

RglExport exportRgl(const ExportSource& source, const RglOptions& options, const TaskControl& control) {
  return source.rgl && !options.fixed ? exportEdited(source, options, control)
                                      : exportParameterised(source, options, control);
}

}  // namespace gonio::exports
