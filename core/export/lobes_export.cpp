// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/lobes_export.h"

#include "core/export/export_report.h"

namespace gonio::exports {

std::pair<ExportResult, ReciprocalLobes> makeLobesExport(std::span<const std::size_t> counts, LobesFormula formula,
                                                         const materials::EditedMaterial& source,
                                                         const ExportOptions& options, const TaskControl& control) {
  constexpr double rendered = 0.1;
  const RenderedComparison comparison = materials::comparisonOf(source, options, control.between(0, rendered));
  const PictureCells cells(source.shown.brdf->isIsotropic());
  ExportResult best;
  ReciprocalLobes chosen;
  const double fraction = (1 - rendered) / double(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const TaskControl part = control.between(rendered + fraction * double(i), rendered + fraction * double(i + 1));
    const ReciprocalLobes start = fitReciprocalLobes(*source.shown.brdf, cells, counts[i], part.between(0, 0.3));
    ReciprocalLobes lobes = refineLobes(*source.shown.brdf, cells, start, formula, part.between(0.3, 0.8));
    ExportResult made;
    measureExport(made, formula(lobes), comparison, part.between(0.8, 1));
    if (best.brdf && !(made.snr > best.snr)) continue;
    best = std::move(made);
    chosen = std::move(lobes);
    if (best.snr >= options.snr) break;
  }
  best.facts = {{"lobes", "GGX lobes", chosen.lobes.size()}};
  return {std::move(best), std::move(chosen)};
}

}  // namespace gonio::exports
