// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/file_targets.h"

#include <limits>

#include "core/export/export_report.h"
#include "core/export/mitsuba_scene.h"
#include "core/export/pbrt_scene.h"
#include "core/export/surface_target.h"
#include "core/io/csv_text.h"

namespace gonio::exports {

using materials::FormatId;

namespace {

constexpr std::string_view rgbSuffix = "_rgb.bsdf", spectralSuffix = "_spec.bsdf";

/// @tparam spectral whether the renderer reads the spectral file, else the RGB file first.
template <bool spectral>
ExportResult makeBsdf(const materials::EditedMaterial& source, const ExportOptions& options,
                      const TaskControl& control) {
  rgl::EncodedRgl files = materials::encodeRgl(source, options, control);
  ExportResult made;
  made.snr = spectral ? files.spectralSnr : files.rgbSnr;
  made.brdf = spectral ? files.spectralBrdf : files.rgbBrdf;
  made.losses = materials::lossesOf(files);
  made.facts = {{"thetaCount", "Incident polar angles", files.size.thetaCount},
                {"size", "Grid size per incident direction", files.size.size},
                {"ownParameterisation", "Nodes of the source", files.ownParameterisation},
                {"unchanged", "Colours copied unchanged", files.unchanged},
                {"negativeValues", "Negative values in the RGB file", files.negativeValues},
                {spectral ? "snrRgb" : "snrSpectral",
                 spectral ? "Rendered SNR of the RGB file" : "Rendered SNR of the spectral file",
                 spectral ? files.rgbSnr : files.spectralSnr}};
  if (files.negativeValues > 0 && !spectral)
    made.warnings.push_back(std::to_string(files.negativeValues) +
                            " negative values (colours outside sRGB), which some renderers set to 0");
  made.parts.push_back({std::string(rgbSuffix), std::move(files.rgb)});
  made.parts.push_back({std::string(spectralSuffix), std::move(files.spectral)});
  return made;
}

/// One file in one of Gonio's formats.
template <FormatId id>
ExportResult makeFile(const materials::EditedMaterial& source, const ExportOptions& options,
                      const TaskControl& control) {
  materials::Encoded file = materials::encode(source, materials::formatOf(id), options, control);
  ExportResult made;
  made.snr = file.snr;
  made.brdf = std::move(file.readBack);
  made.losses = std::move(file.losses);
  made.parts.push_back({std::string(id == FormatId::merlCircle ? "_360.binary" : materials::formatOf(id).suffix()),
                        std::move(file.bytes)});
  return made;
}

/// Directions of the table, degrees.
constexpr int lightPolarStep = 15, lightPolarEnd = 75, lightAzimuthStep = 30, viewerPolarStep = 5, viewerPolarEnd = 85,
              viewerAzimuthStep = 15;

ExportResult makeCsv(const materials::EditedMaterial& source, const ExportOptions&, const TaskControl& control) {
  const bool isotropic = source.shown.brdf->isIsotropic();
  std::string text =
      io::csvComment(materials::originOf(source)) +
      "# BRDF values, linear sRGB in 1/sr without the cosine. Angles in degrees: polar from the normal, azimuth from "
      "the tangent; i: to the light, o: to the viewer.\ntheta_i,phi_i,theta_o,phi_o,red,green,blue\n";
  for (int thetaI = 0; thetaI <= lightPolarEnd; thetaI += lightPolarStep)
    for (int phiI = 0; phiI < (isotropic ? lightAzimuthStep : 360); phiI += lightAzimuthStep) {
      control.throwIfStopped();
      for (int thetaO = 0; thetaO <= viewerPolarEnd; thetaO += viewerPolarStep)
        for (int phiO = 0; phiO <= (isotropic ? 180 : 345); phiO += viewerAzimuthStep) {
          const Rgb value = source.shown.brdf->evaluate(fromSpherical(radians(thetaI), radians(phiI)),
                                                        fromSpherical(radians(thetaO), radians(phiO)));
          for (const int angle : {thetaI, phiI, thetaO, phiO}) text += std::to_string(angle) + ",";
          text += colourText(value, ",") + "\n";
        }
    }
  ExportResult made;
  made.snr = std::numeric_limits<double>::infinity();
  made.brdf = source.shown.brdf;
  made.parts.push_back(textPart(".csv", text));
  return made;
}

ExportTarget bsdfTarget(std::string_view id, std::string_view label, std::string_view description) {
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
      bsdfTarget("mitsuba", "Mitsuba 3",
                 "Two files for the BSDF plugin \"measured\": NAME_rgb.bsdf for the RGB variants, NAME_spec.bsdf for "
                 "the spectral ones.");
  mitsuba.make = makeBsdf<false>;
  mitsuba.scene = &mitsubaSceneFormat();
  return mitsuba;
}

ExportTarget pbrtTarget() {
  ExportTarget pbrt =
      bsdfTarget("pbrt", "pbrt-v4",
                 "Two files: NAME_spec.bsdf for the material \"measured\", and NAME_rgb.bsdf with the same material in "
                 "RGB, for other programs.");
  pbrt.make = makeBsdf<true>;
  pbrt.scene = &pbrtSceneFormat();
  return pbrt;
}

ExportTarget merlTarget() {
  return {.id = "merl",
          .label = "MERL file",
          .description = "A file in the layout of the MERL database, which research code and several renderers read.",
          .limitations = "Isotropic, reciprocal materials at 90 x 90 x 180 half-difference angles.",
          .suffixes = {".binary"},
          .make = makeFile<FormatId::merl>};
}

ExportTarget merlCircleTarget() {
  return {.id = "merl-360",
          .label = "360-degree MERL file",
          .description =
              "The layout of the MERL database with phi_d from 0 to 360 degrees: Gonio reads it, most other programs "
              "do not.",
          .limitations = "Isotropic materials at 90 x 90 x 360 half-difference angles; not necessarily reciprocal.",
          .suffixes = {"_360.binary"},
          .make = makeFile<FormatId::merlCircle>};
}

ExportTarget utiaTarget() {
  return {.id = "utia",
          .label = "UTIA file",
          .description = "A file in the layout of the UTIA BRDF database, for its published code and for Gonio.",
          .limitations =
              "Isotropic and anisotropic materials at 288 x 288 directions: 15 degrees of polar angle by 7.5 of "
              "azimuth, too coarse for sharp highlights.",
          .suffixes = {".bin"},
          .make = makeFile<FormatId::utia>};
}

ExportTarget csvTarget() {
  return {
      .id = "csv",
      .label = "BRDF values (CSV)",
      .description = "BRDF values at a grid of directions as text, for spreadsheets, plots and your own programs.",
      .limitations =
          "Polar angle of the light 0 to 75 degrees in steps of 15, of the viewer 0 to 85 in steps of 5, azimuth in "
          "steps of 15; for anisotropic materials also the azimuth of the light in steps of 30.",
      .suffixes = {".csv"},
      .make = makeCsv};
}

}  // namespace gonio::exports
