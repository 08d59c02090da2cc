// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/table_targets.h"

#include <limits>

#include "core/editing/edit.h"
#include "core/export/export_report.h"
#include "core/export/material_form.h"
#include "core/export/surface_target.h"
#include "core/io/csv_text.h"
#include "core/io/merl_file.h"
#include "core/io/utia_file.h"

namespace gonio::exports {

namespace {

/// Measures what a table shows.
ExportResult tableExport(std::string_view suffix, std::vector<std::byte> bytes, std::shared_ptr<const Brdf> table,
                         const ExportSource& source, const ExportOptions& options, const TaskControl& control) {
  ExportResult made;
  const RenderedComparison comparison = exportComparison(source, options, control.between(0, 0.5));
  measureExport(made, std::move(table), comparison, control.between(0.5, 1));
  made.parts.push_back({std::string(suffix), std::move(bytes)});
  return made;
}

ExportResult makeMerl(std::string_view suffix, const HalfDifferenceGrid& grid, const ExportSource& source,
                      const ExportOptions& options, const TaskControl& control) {
  const TabulatedBrdf* own = source.brdf->asTable();
  const auto table = own && own->grid() == grid
                         ? std::shared_ptr<const TabulatedBrdf>(source.brdf, own)
                         : bakeTable(*source.brdf, grid, control.between(0, 0.5), editing::bakedAzimuths);
  ExportResult made = tableExport(suffix, io::encodeMerl(*table), table, source, options, control.between(0.5, 1));
  if (!source.brdf->isIsotropic()) made.warnings.push_back(azimuthLoss());
  if (grid.reciprocal && !source.brdf->isReciprocal())
    made.warnings.push_back(
        "the material is not reciprocal: the table contains the mean of each value and the value "
        "with light and viewer exchanged");
  return made;
}

constexpr HalfDifferenceGrid circleGrid{.phiDCount = 360, .reciprocal = false};

Direction utiaNode(std::size_t index) {
  const std::size_t polar = index / UtiaBrdf::azimuthCount, azimuth = index % UtiaBrdf::azimuthCount;
  return fromSpherical(UtiaBrdf::polarStep * double(polar), UtiaBrdf::azimuthStep * double(azimuth));
}

/// The values at the nodes with the viewer in the slot of the incident direction, as renderers read them.
std::vector<glm::vec3> utiaValues(const Brdf& material, std::size_t& clipped, const TaskControl& control) {
  constexpr std::size_t side = UtiaBrdf::directionCount;
  std::vector<glm::vec3> values;
  std::vector<DirectionPair> pairs(side);
  std::vector<Rgb> row(side);
  for (std::size_t viewer = 0; viewer < side; ++viewer) {
    control.throwIfStopped();
    for (std::size_t light = 0; light < side; ++light) pairs[light] = {utiaNode(light), utiaNode(viewer)};
    material.evaluate(pairs, row);
    for (const Rgb& value : row) {
      for (int c = 0; c < 3; ++c) clipped += value[c] < 0;
      values.emplace_back(glm::max(value, Rgb(0)));
    }
  }
  return values;
}

ExportResult makeUtia(const ExportSource& source, const ExportOptions& options, const TaskControl& control) {
  std::size_t clipped = 0;
  std::vector<glm::vec3> values = utiaValues(*source.brdf, clipped, control.between(0, 0.3));
  std::vector<std::byte> bytes = io::encodeUtia(values);
  ExportResult made = tableExport(".bin", std::move(bytes), std::make_shared<const UtiaBrdf>(std::move(values)), source,
                                  options, control.between(0.3, 1));
  made.facts = {{"clippedValues", "Negative values set to 0", clipped}};
  return made;
}

/// Directions of the table, degrees.
constexpr int lightPolarStep = 15, lightPolarEnd = 75, lightAzimuthStep = 30, viewerPolarStep = 5, viewerPolarEnd = 85,
              viewerAzimuthStep = 15;

ExportResult makeCsv(const ExportSource& source, const ExportOptions&, const TaskControl& control) {
  const bool isotropic = source.brdf->isIsotropic();
  std::string text =
      io::csvComment(source.origin) +
      "# BRDF values, linear sRGB in 1/sr without the cosine. Angles in degrees: polar from the normal, azimuth from "
      "the tangent; i: to the light, o: to the viewer.\ntheta_i,phi_i,theta_o,phi_o,red,green,blue\n";
  for (int thetaI = 0; thetaI <= lightPolarEnd; thetaI += lightPolarStep)
    for (int phiI = 0; phiI < (isotropic ? lightAzimuthStep : 360); phiI += lightAzimuthStep) {
      control.throwIfStopped();
      for (int thetaO = 0; thetaO <= viewerPolarEnd; thetaO += viewerPolarStep)
        for (int phiO = 0; phiO <= (isotropic ? 180 : 345); phiO += viewerAzimuthStep) {
          const Rgb value = source.brdf->evaluate(fromSpherical(radians(thetaI), radians(phiI)),
                                                  fromSpherical(radians(thetaO), radians(phiO)));
          for (const int angle : {thetaI, phiI, thetaO, phiO}) text += std::to_string(angle) + ",";
          text += colourText(value, ",") + "\n";
        }
    }
  ExportResult made;
  made.snr = std::numeric_limits<double>::infinity();
  made.brdf = source.brdf;
  made.parts.push_back(textPart(".csv", text));
  return made;
}

}  // namespace

ExportTarget merlTarget() {
  return {.id = "merl",
          .label = "MERL file",
          .description = "A file in the layout of the MERL database, which research code and several renderers read.",
          .limitations = "Isotropic, reciprocal materials at 90 x 90 x 180 half-difference angles.",
          .suffixes = {".binary"},
          .make = [](const ExportSource& source, const ExportOptions& options, const TaskControl& control) {
            return makeMerl(".binary", {}, source, options, control);
          }};
}

ExportTarget merlCircleTarget() {
  return {.id = "merl-360",
          .label = "360-degree MERL file",
          .description =
              "The layout of the MERL database with phi_d from 0 to 360 degrees: Gonio reads it, most other programs "
              "do not.",
          .limitations = "Isotropic materials at 90 x 90 x 360 half-difference angles; not necessarily reciprocal.",
          .suffixes = {"_360.binary"},
          .make = [](const ExportSource& source, const ExportOptions& options, const TaskControl& control) {
            return makeMerl("_360.binary", circleGrid, source, options, control);
          }};
}

ExportTarget utiaTarget() {
  return {.id = "utia",
          .label = "UTIA file",
          .description = "A file in the layout of the UTIA BRDF database, for its published code and for Gonio.",
          .limitations =
              "Isotropic and anisotropic materials at 288 x 288 directions: 15 degrees of polar angle by 7.5 of "
              "azimuth, too coarse for sharp highlights.",
          .suffixes = {".bin"},
          .make = makeUtia};
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
