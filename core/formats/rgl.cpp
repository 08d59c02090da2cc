// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/formats/rgl.h"

#include <algorithm>

#include "core/brdf/rgl_brdf.h"
#include "core/formats/formats.h"
#include "core/rgl/rgl_file.h"

namespace gonio::formats {

using materials::EditedMaterial, materials::Encoded, materials::EncodeOptions, materials::Material;

namespace {

void readRglMaterial(const io::ByteSource& source, const TaskControl& control, Material& material) {
  control.throwIfStopped();
  rgl::RglFile file = rgl::readRgl(source);
  material.brdf = std::move(file.brdf);
  material.source.description = std::move(file.description);
  material.source.grid = std::move(file.grid);
  if (file.isSpectral)
    material.source.notes.push_back("spectra are converted to colours under D65 with the CIE 1931 observer");
  if (file.negativeCount > 0)
    material.source.notes.push_back(std::to_string(file.negativeCount) +
                                    " negative values (colours outside the sRGB gamut) are preserved");
}

bool changesOnlyColours(const editing::Edit& edit) {
  const auto* change = std::get_if<editing::DifferentialEdit>(&edit.content);
  return edit.isIdentity() || (change && !change->changesModel());
}

/// The spectral file if the material is a spectral RGL file whose spectra encodeRgl() keeps, else the RGB file.
Encoded encodeRglMaterial(const EditedMaterial& material, const EncodeOptions& options, const TaskControl& control) {
  rgl::EncodedRgl files = encodeRgl(material, options, control);
  const bool spectral = material.base.brdf->isSpectral() && files.ownParameterisation;
  Encoded made{spectral ? std::move(files.spectral) : std::move(files.rgb),
               spectral ? files.spectralBrdf : files.rgbBrdf, lossesOf(files)};
  made.snr = spectral ? files.spectralSnr : files.rgbSnr;
  return made;
}

constexpr std::string_view rglSuffixes[] = {".bsdf"};

}  // namespace

rgl::EncodedRgl encodeRgl(const EditedMaterial& material, const EncodeOptions& options, const TaskControl& control) {
  std::optional<rgl::RglFileSource> source;
  const Material& base = material.base;
  if (const auto file = formOf<RglBrdf>(base.brdf)) {
    source = {.brdf = file};
    source->bytes = base.source.format == rglFormat.name && !base.source.path.empty()
                        ? materials::materialFile(base.source)
                        : rgl::encodeRglData(rgl::wholeData(*file->tables()), originOf(material), rgl::RglColours::rgb);
    source->onlyColoursChanged = std::ranges::all_of(material.edits, changesOnlyColours);
  }
  const auto pictures = [&](const TaskControl& part) { return comparisonOf(material, options, part); };
  return rgl::encodeRgl(*material.shown.brdf, source ? &*source : nullptr, originOf(material),
                        {.snr = options.snr, .size = options.size}, pictures, control);
}

std::vector<std::string> lossesOf(const rgl::EncodedRgl& files) {
  std::vector<std::string> losses;
  const auto count = [](std::size_t number) { return std::to_string(number); };
  if (!files.ownParameterisation)
    losses.push_back("the values were sampled at " + count(files.size.thetaCount) + " polar angles x " +
                     count(files.size.size) + " x " + count(files.size.size) + " nodes");
  if (!files.keepsSpectra)
    losses.push_back("the material has spectra: the file contains smooth spectra of their colours");
  return losses;
}

constinit const MaterialFormat rglFormat{
    .name = "RGL",
    .label = "RGL file",
    .suffixes = rglSuffixes,
    .isMeasurement = true,
    .holds = {.nonReciprocal = true, .anisotropic = true, .spectral = true},
    .sniff = io::expectTensorFile,
    .read = readRglMaterial,
    .encode = encodeRglMaterial,
    .isOwnForm = [](const Brdf& brdf) { return formOf<RglBrdf>(brdf) != nullptr; }};

}  // namespace gonio::formats
