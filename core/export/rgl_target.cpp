// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/rgl_target.h"

#include "core/export/mitsuba_scene.h"
#include "core/export/pbrt_scene.h"
#include "core/export/rgl_export.h"

namespace gonio::exports {

namespace {

constexpr std::string_view rgbSuffix = "_rgb.bsdf", spectralSuffix = "_spec.bsdf";

template <bool bothSides>
ExportResult makeBsdf(const ExportSource& source, const ExportOptions& options, const TaskControl& control) {
  RglOptions rgl;
  rgl.bothSides = bothSides;
  rgl.snr = options.snr;
  rgl.fixed = options.size;
  rgl.pictureSize = options.pictureSize;
  rgl.samples = options.samples;
  RglExport files = exportRgl(source, rgl, control);
  ExportResult made;
  made.snr = files.snr;
  made.brdf = std::move(files.brdf);
  made.facts = {{"thetaCount", "Incident polar angles", files.size.thetaCount},
                {"size", "Grid size per incident direction", files.size.size},
                {"unchanged", "Colours copied unchanged", files.unchanged},
                {"negativeValues", "Negative values", files.negativeValues},
                {"clippedValues", "Negative values set to 0", files.clippedValues}};
  if (files.negativeValues > 0)
    made.warnings.push_back(std::to_string(files.negativeValues) +
                            " negative values (colours outside sRGB): renderers clip them differently");
  made.parts.push_back({std::string(rgbSuffix), std::move(files.rgb)});
  made.parts.push_back({std::string(spectralSuffix), std::move(files.spectral)});
  return made;
}

ExportTarget target(std::string_view id, std::string_view label, std::string_view description) {
  return {.id = id,
          .label = label,
          .description = description,
          .limitations =
              "Any BRDF, isotropic or anisotropic, as values in the parameterisation of the RGL database; the stored "
              "values of an RGL file are copied unchanged. No transmission.",
          .suffixes = {rgbSuffix, spectralSuffix},
          .usesSize = true,
          .usesSnr = true};
}

}  // namespace

ExportTarget mitsubaTarget() {
  ExportTarget mitsuba =
      target("mitsuba", "Mitsuba 3",
             "Two files for the BSDF plugin \"measured\": NAME_rgb.bsdf for the RGB variants, NAME_spec.bsdf for the "
             "spectral ones. For isotropic materials, both sides of the plane of incidence are averaged.");
  mitsuba.make = makeBsdf<false>;
  mitsuba.scene = &mitsubaSceneFormat();
  return mitsuba;
}

ExportTarget pbrtTarget() {
  ExportTarget pbrt = target("pbrt", "pbrt-v4",
                             "Two files: NAME_spec.bsdf for the material \"measured\", and NAME_rgb.bsdf with the same "
                             "material in RGB, for other programs. For isotropic materials, both sides of the plane of "
                             "incidence are stored; for Mitsuba, use the target Mitsuba 3.");
  pbrt.make = makeBsdf<true>;
  pbrt.scene = &pbrtSceneFormat();
  return pbrt;
}

}  // namespace gonio::exports
