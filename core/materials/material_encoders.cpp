// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/material_encoders.h"

#include <algorithm>
#include <array>

#include "core/io/merl_file.h"
#include "core/io/utia_file.h"

namespace gonio::materials {

namespace {

std::string gridText(const HalfDifferenceGrid& grid) {
  return std::to_string(grid.thetaHCount) + " x " + std::to_string(grid.thetaDCount) + " x " +
         std::to_string(grid.phiDCount);
}

std::string clippedText(std::size_t count) { return std::to_string(count) + " negative values were set to 0"; }

/// The table of a material with a grid that folds phi_d or does not; null if it has none.
std::shared_ptr<const TabulatedBrdf> ownTable(const EditedMaterial& material, bool reciprocal,
                                              const TaskControl& control) {
  const auto& [shown, base] = std::tie(material.shown, material.base);
  if (shown.table && shown.table->grid().reciprocal == reciprocal) return shown.table;
  if (!base.table || base.table->grid().reciprocal != reciprocal) return nullptr;
  // Cell by cell: cells without data keep none.
  return editing::bakeEdits(base.table, material.edits, control);
}

/// @param usual the grid where the options have none of this kind.
Encoded encodeTable(const EditedMaterial& material, const HalfDifferenceGrid& usual, const EncodeOptions& options,
                    const TaskControl& control) {
  const HalfDifferenceGrid grid = options.grid && options.grid->reciprocal == usual.reciprocal ? *options.grid : usual;
  if (const auto own = ownTable(material, grid.reciprocal, control)) return {io::encodeMerl(*own), own};
  const auto table = bakeTable(*material.shown.brdf, grid, control, editing::bakedAzimuths);
  Encoded made{io::encodeMerl(*table), table};
  made.losses.push_back("the values were sampled at " + gridText(grid) + " half-difference angles");
  if (table->clampedCount() > 0) made.losses.push_back(clippedText(table->clampedCount()));
  return made;
}

/// The values at the nodes of UTIA files. Those of a UTIA file change by the difference that the edits make there.
std::vector<glm::vec3> utiaValues(const EditedMaterial& material, const TaskControl& control) {
  const auto* file = dynamic_cast<const UtiaBrdf*>(material.base.brdf.get());
  if (file && material.shown.brdf == material.base.brdf) return *file->values();
  const auto own = file ? file->withIncident(IncidentDirection::viewer) : nullptr;
  constexpr std::size_t side = UtiaBrdf::directionCount;
  std::vector<glm::vec3> values(side * side);
  std::vector<Rgb> before(side, Rgb(0)), after(side);
  for (std::size_t incident = 0; incident < side; ++incident) {
    control.throwIfStopped();
    const std::vector<DirectionPair> pairs = UtiaBrdf::nodes(incident);
    material.shown.brdf->evaluate(pairs, after);
    if (own) own->evaluate(pairs, before);
    for (std::size_t i = 0; i < side; ++i) {
      const std::size_t node = incident * side + i;
      const Rgb start = own ? Rgb((*file->values())[node]) : Rgb(0);
      values[node] = glm::vec3(before[i] == after[i] ? start : start + after[i] - before[i]);
    }
    control.report(double(incident) / side);
  }
  return values;
}

}  // namespace

Encoded encodeMerlMaterial(const EditedMaterial& material, const EncodeOptions& options, const TaskControl& control) {
  return encodeTable(material, {}, options, control);
}

Encoded encodeMerlCircleMaterial(const EditedMaterial& material, const EncodeOptions& options,
                                 const TaskControl& control) {
  return encodeTable(material, {.phiDCount = 360, .reciprocal = false}, options, control);
}

Encoded encodeRglMaterial(const EditedMaterial& material, const EncodeOptions& options, const TaskControl& control) {
  rgl::EncodedRgl files = encodeRgl(material, options, control);
  const RglBrdf* source = material.base.brdf->asRgl();
  const bool spectral = source && source->tables()->data.spectra && files.ownParameterisation;
  Encoded made{spectral ? std::move(files.spectral) : std::move(files.rgb),
               spectral ? files.spectralBrdf : files.rgbBrdf, lossesOf(files)};
  made.snr = spectral ? files.spectralSnr : files.rgbSnr;
  return made;
}

Encoded encodeUtiaMaterial(const EditedMaterial& material, const EncodeOptions&, const TaskControl& control) {
  std::vector<glm::vec3> values = utiaValues(material, control);
  Encoded made;
  std::size_t clipped = 0;
  for (glm::vec3& value : values) {
    clipped += std::size_t((value.x < 0) + (value.y < 0) + (value.z < 0));
    value = glm::max(value, glm::vec3(0));
  }
  made.bytes = io::encodeUtia(values);
  if (!dynamic_cast<const UtiaBrdf*>(material.base.brdf.get()))
    made.losses.push_back("the values were sampled at 288 x 288 directions, every 15 by 7.5 degrees");
  if (clipped > 0) made.losses.push_back(clippedText(clipped));
  made.readBack = std::make_shared<const UtiaBrdf>(std::move(values));
  return made;
}

}  // namespace gonio::materials
