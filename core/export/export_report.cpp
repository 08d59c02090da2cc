// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/export_report.h"

#include <cmath>
#include <cstdio>

namespace gonio::exports {

void measureExport(ExportResult& made, std::shared_ptr<const Brdf> brdf, const RenderedComparison& comparison,
                   const TaskControl& control) {
  made.snr = comparison.signalToNoiseRatio(comparison.render(*brdf, control));
  made.brdf = std::move(brdf);
}

std::string originText(const materials::EditedMaterial& source, double snr) {
  char accuracy[80] = ". Rendered images are identical (comparison scene).";
  if (std::isfinite(snr)) std::snprintf(accuracy, sizeof accuracy, ". Rendered SNR %.1f dB (comparison scene).", snr);
  return materials::originOf(source) + accuracy;
}

ExportPart textPart(std::string_view suffix, std::string_view text) {
  const auto* bytes = reinterpret_cast<const std::byte*>(text.data());
  return {std::string(suffix), {bytes, bytes + text.size()}};
}

std::string meanAzimuthWarning() {
  return "the material is anisotropic: the export contains the mean over all azimuths";
}

}  // namespace gonio::exports
