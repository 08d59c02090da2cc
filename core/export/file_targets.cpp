// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors

#include "core/export/export_files.h"
#include "core/export/scenes/scene_files.h"
#include "core/export/target_table.h"
#include "core/formats/formats.h"
#include "core/formats/rgl.h"
#include "core/io/csv_text.h"
#include "core/io/exr_codec.h"
#include "core/plots/plotted_values.h"

namespace gonio::exports {

namespace {

constexpr std::string_view rgbSuffix = "_rgb.bsdf", spectralSuffix = "_spec.bsdf";

/// @tparam spectral whether the renderer reads the spectral file, else the RGB file first.
template <bool spectral>
ExportResult makeBsdf(const materials::EditedMaterial& source, const ExportOptions& options,
                      const TaskControl& control) {
  rgl::EncodedRgl files = formats::encodeRgl(source, options, control);
  ExportResult made;
  made.snr = spectral ? files.spectralSnr : files.rgbSnr;
  made.brdf = spectral ? files.spectralBrdf : files.rgbBrdf;
  made.losses = formats::lossesOf(files);
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
template <const materials::MaterialFormat& format>
ExportResult makeFile(const materials::EditedMaterial& source, const ExportOptions& options,
                      const TaskControl& control) {
  materials::Encoded file = materials::encode(source, format, options, control);
  ExportResult made;
  made.snr = file.snr;
  made.brdf = std::move(file.readBack);
  made.losses = std::move(file.losses);
  made.parts.push_back(
      {std::string(&format == &formats::merlCircleFormat ? "_360.binary" : format.suffix()), std::move(file.bytes)});
  return made;
}

/// Directions of the table, degrees.
constexpr int lightPolarStep = 15, lightPolarEnd = 75, lightAzimuthStep = 30, viewerPolarStep = 5, viewerPolarEnd = 85,
              viewerAzimuthStep = 15;

ExportResult makeCsv(const materials::EditedMaterial& source, const ExportOptions&, const TaskControl& control) {
  const bool isotropic = source.shown.brdf->isIsotropic();
  std::size_t count = 0;
  io::CsvWriter csv;
  csv.comment(materials::originOf(source));
  csv.comment(
      "BRDF values, linear sRGB in 1/sr without the cosine. Angles in degrees: polar from the normal, azimuth from the "
      "tangent; i: to the light, o: to the viewer.");
  csv.texts({"theta_i", "phi_i", "theta_o", "phi_o", "red", "green", "blue"}).endLine();
  for (int thetaI = 0; thetaI <= lightPolarEnd; thetaI += lightPolarStep)
    for (int phiI = 0; phiI < (isotropic ? lightAzimuthStep : 360); phiI += lightAzimuthStep) {
      control.throwIfStopped();
      for (int thetaO = 0; thetaO <= viewerPolarEnd; thetaO += viewerPolarStep)
        for (int phiO = 0; phiO <= (isotropic ? 180 : 345); phiO += viewerAzimuthStep) {
          const Rgb value = source.shown.brdf->evaluate(fromSpherical(radians(thetaI), radians(phiI)),
                                                        fromSpherical(radians(thetaO), radians(phiO)));
          for (const int angle : {thetaI, phiI, thetaO, phiO}) csv.integer(angle);
          for (int c = 0; c < 3; ++c) csv.literal(sixDigitText(value[c]));
          csv.endLine();
          ++count;
        }
    }
  ExportResult made;
  made.losses.push_back("the file contains values at " + std::to_string(count) +
                        " pairs of directions and nothing between them");
  made.parts.push_back(textPart(".csv", csv.str()));
  return made;
}

constexpr std::string_view slicesSuffix = "_slices.exr";
constexpr int slicesSide = 180;
/// Degrees. A reciprocal material that is the same on both sides of the plane of incidence has no others.
constexpr int slicesPhiD[] = {0, 30, 60, 90};

ExportResult makeSlices(const materials::EditedMaterial& source, const ExportOptions&, const TaskControl& control) {
  Image image(int(std::size(slicesPhiD)) * slicesSide, slicesSide);
  std::string azimuths;
  for (std::size_t i = 0; i < std::size(slicesPhiD); ++i) {
    control.throwIfStopped();
    const plots::Slice slice =
        plots::sliceOf(*source.shown.brdf, plots::SliceCoordinates::halfDifference, radians(slicesPhiD[i]),
                       plots::ThetaHSpacing::squareRoot, plots::CosineFactor::none, nullptr, slicesSide);
    for (int row = 0; row < slicesSide; ++row)
      for (int column = 0; column < slicesSide; ++column)
        image.at(int(i) * slicesSide + column, slicesSide - 1 - row) =
            glm::vec3(slice.cells.values[slice.index(column, row)]);
    azimuths += (i ? ", " : "") + std::to_string(slicesPhiD[i]);
  }
  ExportResult made;
  made.losses.push_back("the image contains values at " + std::to_string(std::size(slicesPhiD)) +
                        " azimuths phi_d and nothing between them");
  made.parts.push_back(
      {std::string(slicesSuffix),
       io::encodeExr(image, {{"comments", materials::originOf(source)},
                             {"slices", "from left to right: phi_d = " + azimuths +
                                            " degrees; along x: theta_h = 90 u^2 degrees, u from 0 to 1; along y: "
                                            "theta_d from 0 at the bottom to 90 degrees at the top; linear sRGB, 1/sr "
                                            "without the cosine; 0 where a direction is below the surface"}})});
  return made;
}

ExportTarget bsdfTarget(std::string_view id, std::string_view label, std::string_view icon, std::string_view purpose,
                        std::string_view description) {
  return {.id = id,
          .label = label,
          .icon = icon,
          .purpose = purpose,
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
      bsdfTarget("mitsuba", "Mitsuba 3", "target-sphere-light", "Renders in Mitsuba 3 as it looks here.",
                 "Two files for the BSDF plugin \"measured\": NAME_rgb.bsdf for the RGB variants, NAME_spec.bsdf for "
                 "the spectral ones.");
  mitsuba.make = makeBsdf<false>;
  mitsuba.scene = &mitsubaSceneFormat();
  return mitsuba;
}

ExportTarget pbrtTarget() {
  ExportTarget pbrt =
      bsdfTarget("pbrt", "pbrt-v4", "target-film", "Renders in pbrt-v4 as it looks here.",
                 "Two files: NAME_spec.bsdf for the material \"measured\", and NAME_rgb.bsdf with the same material in "
                 "RGB, for other programs.");
  pbrt.make = makeBsdf<true>;
  pbrt.scene = &pbrtSceneFormat();
  return pbrt;
}

ExportTarget merlTarget() {
  return {.id = "merl",
          .label = "MERL file",
          .icon = "target-table",
          .purpose = "Opens in research tools and in renderers that read MERL files.",
          .description = "A file in the layout of the MERL database, which research code and several renderers read.",
          .limitations = "Isotropic, reciprocal materials at 90 x 90 x 180 half-difference angles.",
          .suffixes = {".binary"},
          .make = makeFile<formats::merlFormat>};
}

ExportTarget merlCircleTarget() {
  return {.id = "merl-360",
          .label = "360-degree MERL file",
          .icon = "target-circle-table",
          .purpose = "Stores the full measurement for Gonio; other programs cannot read it.",
          .description =
              "The layout of the MERL database with phi_d from 0 to 360 degrees: Gonio reads it, most other programs "
              "do not.",
          .limitations = "Isotropic materials at 90 x 90 x 360 half-difference angles; not necessarily reciprocal.",
          .suffixes = {"_360.binary"},
          .make = makeFile<formats::merlCircleFormat>};
}

ExportTarget utiaTarget() {
  return {.id = "utia",
          .label = "UTIA file",
          .icon = "target-hemisphere",
          .purpose = "Opens in the tools of the UTIA database; suits rough materials and fabrics.",
          .description = "A file in the layout of the UTIA BRDF database, for its published code and for Gonio.",
          .limitations =
              "Isotropic and anisotropic materials at 288 x 288 directions: 15 degrees of polar angle by 7.5 of "
              "azimuth, too coarse for sharp highlights.",
          .suffixes = {".bin"},
          .make = makeFile<formats::utiaFormat>};
}

ExportTarget csvTarget() {
  return {
      .id = "csv",
      .label = "BRDF values (CSV)",
      .icon = "target-spreadsheet",
      .purpose = "Opens as a table of numbers in a spreadsheet.",
      .description = "BRDF values at a grid of directions as text, for spreadsheets, plots and your own programs.",
      .limitations =
          "Polar angle of the light 0 to 75 degrees in steps of 15, of the viewer 0 to 85 in steps of 5, azimuth in "
          "steps of 15; for anisotropic materials also the azimuth of the light in steps of 30.",
      .suffixes = {".csv"},
      .make = makeCsv};
}

ExportTarget slicesTarget() {
  return {.id = "slices",
          .label = "Slices (OpenEXR)",
          .icon = "target-slices",
          .purpose = "Shows the material as an image for a figure; it does not render.",
          .description = "An image of four planes of half-difference space, theta_h by theta_d, for figures.",
          .limitations =
              "Values at phi_d of 0, 30, 60 and 90 degrees; for an anisotropic material with the half vector "
              "tilted towards x, the brushing direction. No renderer reads this file.",
          .suffixes = {slicesSuffix},
          .make = makeSlices};
}

}  // namespace gonio::exports
