// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/encode.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/brdf/utia_brdf.h"
#include "core/io/atomic_file.h"
#include "core/materials/material_file.h"
#include "core/metrics/brdf_metrics.h"
#include "core/rgl/rgl_fields.h"
#include "core/support/file_in_errors.h"
#include "core/support/lower_case.h"

namespace gonio::materials {

namespace {

/// Whether a reader of the file gets the material: it has no edits, and the file is read as readers do.
bool isUnchanged(const EditedMaterial& material) {
  return material.shown.brdf == material.base.brdf &&
         incidentDirectionOf(*material.base.brdf).value_or(IncidentDirection::viewer) == IncidentDirection::viewer;
}

/// Whether the file that was read is already what is wanted.
bool isOwnFile(const EditedMaterial& material, const MaterialFormat& format) {
  const Material& base = material.base;
  if (!isUnchanged(material) || base.source.format != format.name || base.source.path.empty()) return false;
  // Of RGL files the encoder decides, of UTIA files the suffix: OpenEXR images are not written.
  return base.table || (format.id == FormatId::utia && base.source.path.extension() == format.suffix());
}

/// What a material is that a format cannot hold.
std::vector<std::string> unheld(const EditedMaterial& material, const FormatCapabilities& holds) {
  std::vector<std::string> losses;
  const Brdf& brdf = *material.shown.brdf;
  if (!holds.anisotropic && !brdf.isIsotropic())
    losses.push_back("the material is anisotropic: the file contains its mean over " +
                     std::to_string(editing::bakedAzimuths) + " azimuths");
  if (!holds.nonReciprocal && !brdf.isReciprocal())
    losses.push_back(
        "the material is not reciprocal: the file contains the mean of each value and the value with light and viewer "
        "exchanged");
  const RglBrdf* rgl = material.base.brdf->asRgl();
  if (!holds.spectral && rgl && rgl->tables()->data.spectra)
    losses.push_back("the material has spectra: the file contains their colours under D65");
  return losses;
}

std::vector<const MaterialFormat*> withSuffix(const std::filesystem::path& path) {
  const std::string suffix = lowerCase(path.extension().string());
  std::vector<const MaterialFormat*> found;
  for (const MaterialFormat& format : materialFormats())
    if (format.encode && format.suffix() == suffix) found.push_back(&format);
  return found;
}

}  // namespace

RenderedComparison comparisonOf(const EditedMaterial& material, const EncodeOptions& options,
                                const TaskControl& control) {
  RenderOptions pictures;
  pictures.width = pictures.height = options.pictureSize;
  pictures.samples = options.samples;
  return RenderedComparison(*material.shown.brdf, pictures, control);
}

Encoded encode(const EditedMaterial& material, const MaterialFormat& format, const EncodeOptions& options,
               const TaskControl& control) {
  if (!format.encode)
    throw Error("found the format " + std::string(format.name) + ", which is only read, expected " +
                writableSuffixText());
  const bool isCopy = isOwnFile(material, format);
  Encoded made = isCopy ? Encoded{materialFile(material.base.source), material.shown.brdf}
                        : format.encode(material, options, control.between(0, 0.6));
  if (made.readBack == material.shown.brdf) return made;
  std::ranges::copy(unheld(material, format.holds), std::back_inserter(made.losses));
  // The encoder of RGL files has rendered them.
  if (format.id != FormatId::rgl) {
    const RenderedComparison pictures = comparisonOf(material, options, control.between(0.6, 0.8));
    made.snr = pictures.signalToNoiseRatio(pictures.render(*made.readBack, control.between(0.8, 0.9)));
  }
  made.brdfSnr = metrics::brdfSignalToNoiseRatio(*material.shown.brdf, *made.readBack);
  control.throwIfStopped();
  return made;
}

Encoded writeMaterial(const EditedMaterial& material, const std::filesystem::path& path, const EncodeOptions& options,
                      const TaskControl& control) {
  const MaterialFormat& format = writableFormat(path, *material.shown.brdf, options);
  Encoded made = withFileInErrors(path, [&] { return encode(material, format, options, control); });
  io::writeFileAtomically(path, made.bytes);
  return made;
}

namespace {

bool changesOnlyColours(const editing::Edit& edit) {
  const auto* change = std::get_if<editing::DifferentialEdit>(&edit.content);
  return edit.isIdentity() || (change && !change->changesModel());
}

}  // namespace

rgl::EncodedRgl encodeRgl(const EditedMaterial& material, const EncodeOptions& options, const TaskControl& control) {
  std::optional<rgl::RglFileSource> source;
  const Material& base = material.base;
  if (const RglBrdf* rgl = base.brdf->asRgl()) {
    source = {.brdf = {base.brdf, rgl}};
    source->bytes = base.source.format == formatOf(FormatId::rgl).name && !base.source.path.empty()
                        ? materialFile(base.source)
                        : rgl::encodeRglData(rgl::wholeData(*rgl->tables()), originOf(material), rgl::RglColours::rgb);
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

std::vector<const MaterialFormat*> writableFormats(const Brdf& material) {
  const auto score = [&](const MaterialFormat* format) {
    const TabulatedBrdf* table = material.asTable();
    const bool isTable = format->id == FormatId::merl || format->id == FormatId::merlCircle;
    if (table && isTable) return table->grid().reciprocal == !format->holds.nonReciprocal ? 4 : 3;
    if (dynamic_cast<const UtiaBrdf*>(&material) && format->id == FormatId::utia) return 5;
    return format->id == FormatId::rgl ? 2 : format->id == FormatId::utia ? -1 : format->holds.nonReciprocal ? 1 : 0;
  };
  std::vector<const MaterialFormat*> formats;
  for (const MaterialFormat& format : materialFormats())
    if (format.encode) formats.push_back(&format);
  std::ranges::stable_sort(formats, std::greater(), score);
  return formats;
}

const MaterialFormat& writableFormat(const std::filesystem::path& path, const Brdf& material,
                                     const EncodeOptions& options) {
  checkWritableSuffix(path);
  const std::vector<const MaterialFormat*> found = withSuffix(path);
  const TabulatedBrdf* table = material.asTable();
  const bool wholeCircle = options.grid ? !options.grid->reciprocal : table && !table->grid().reciprocal;
  for (const MaterialFormat* format : found)
    if (format->holds.nonReciprocal == wholeCircle) return *format;
  return *found.front();
}

void checkWritableSuffix(const std::filesystem::path& path, std::string_view other) {
  if (!withSuffix(path).empty()) return;
  throw Error(path.string() + ": found the suffix '" + path.extension().string() + "', expected " +
              writableSuffixText(other));
}

std::string shortfall(const Encoded& made, const MaterialFormat& format, const EncodeOptions& options) {
  if (!(made.snr < options.snr)) return {};
  char text[96];
  std::snprintf(text, sizeof text, "rendered SNR %.1f dB, less than %.0f dB", made.snr, options.snr);
  const char* help = format.id != FormatId::rgl ? "an RGL file (.bsdf) is usually closer to the material"
                     : options.size             ? "without a given size, the size follows the material"
                                                : "no larger file comes closer";
  return std::string(text) + ": " + help;
}

}  // namespace gonio::materials
