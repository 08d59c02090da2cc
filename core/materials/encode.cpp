// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/encode.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "core/io/atomic_file.h"
#include "core/materials/material.h"
#include "core/metrics/brdf_metrics.h"
#include "core/rgl/rgl_file.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::materials {

namespace {

/// Whether a reader of the file gets the material: it has no edits, and the file is read as readers do.
bool isUnchanged(const EditedMaterial& material) {
  return material.shown.brdf == material.base.brdf &&
         material.base.brdf->incidentDirection().value_or(IncidentDirection::viewer) == IncidentDirection::viewer;
}

/// The properties of a material that a format cannot represent, as sentences for the user.
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
  if (!holds.spectral && material.base.brdf->isSpectral())
    losses.push_back("the material has spectra: the file contains their colours under D65");
  return losses;
}

std::vector<const MaterialFormat*> withSuffix(const std::filesystem::path& path) {
  const std::string suffix = lowerCase(path.extension().string());
  std::vector<const MaterialFormat*> found;
  for (const MaterialFormat* format : materialFormats())
    if (format->encode && format->suffix() == suffix) found.push_back(format);
  return found;
}

}  // namespace

rendering::RenderedComparison comparisonOf(const EditedMaterial& material, const EncodeOptions& options,
                                           const TaskControl& control) {
  rendering::RenderOptions pictures;
  pictures.width = pictures.height = options.pictureSize;
  pictures.samples = options.samples;
  return rendering::RenderedComparison(*material.shown.brdf, pictures, control);
}

std::optional<Encoded> copyOfFile(const EditedMaterial& material, const MaterialFormat& format) {
  const MaterialSource& source = material.base.source;
  const bool hasFile = source.format == format.name && lowerCase(source.path.extension().string()) == format.suffix();
  if (!hasFile || !isUnchanged(material)) return std::nullopt;
  return Encoded{materialFile(source), material.shown.brdf};
}

Encoded encode(const EditedMaterial& material, const MaterialFormat& format, const EncodeOptions& options,
               const TaskControl& control) {
  if (!format.encode)
    throw Error("found the format " + std::string(format.name) + ", which is only read, expected " +
                writableSuffixText());
  Encoded made = format.encode(material, options, control.between(0, 0.6));
  if (made.readBack == material.shown.brdf) return made;
  std::ranges::copy(unheld(material, format.holds), std::back_inserter(made.losses));
  if (std::isinf(made.snr)) {
    const rendering::RenderedComparison pictures = comparisonOf(material, options, control.between(0.6, 0.8));
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

std::vector<const MaterialFormat*> writableFormats(const Brdf& material) {
  const auto score = [&](const MaterialFormat* format) {
    const FormatCapabilities& holds = format->holds;
    if (format->isOwnForm(material)) return 4;
    return format->isSuffixAmbiguous ? -1 : int(holds.nonReciprocal) + int(holds.anisotropic) + int(holds.spectral);
  };
  std::vector<const MaterialFormat*> formats;
  for (const MaterialFormat* format : materialFormats())
    if (format->encode) formats.push_back(format);
  std::ranges::stable_sort(formats, std::greater(), score);
  return formats;
}

const MaterialFormat& writableFormat(const std::filesystem::path& path, const Brdf& material,
                                     const EncodeOptions& options) {
  checkWritableSuffix(path);
  const std::vector<const MaterialFormat*> found = withSuffix(path);
  const auto wanted = std::ranges::find_if(found, [&](const MaterialFormat* format) {
    return options.grid ? format->holds.nonReciprocal == !options.grid->reciprocal : format->isOwnForm(material);
  });
  return wanted == found.end() ? *found.front() : **wanted;
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
  const char* help = !format.holds.spectral ? "an RGL file (.bsdf) is usually closer to the material"
                     : options.size         ? "without a given size, the size follows the material"
                                            : "no larger file comes closer";
  return std::string(text) + ": " + help;
}

}  // namespace gonio::materials
