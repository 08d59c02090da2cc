// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/target_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/export/export_files.h"

namespace gonio::exports {

std::span<const ExportTarget> exportTargets() {
  static const std::vector<ExportTarget> targets = [] {
    std::vector<ExportTarget> all;
    const auto add = [&](TargetGroup group, std::initializer_list<ExportTarget> members) {
      for (const ExportTarget& one : members) all.emplace_back(one).group = group;
    };
    add(TargetGroup::renderers, {mitsubaTarget(), pbrtTarget()});
    add(TargetGroup::engines, {blenderTarget(), principledTarget(), gltfTarget(), materialXTarget(), openPbrTarget(),
                               standardSurfaceTarget(), valuesTarget(), glslTarget()});
    add(TargetGroup::data, {merlTarget(), merlCircleTarget(), utiaTarget(), csvTarget(), slicesTarget()});
    return all;
  }();
  return targets;
}

const ExportTarget* findExportTarget(std::string_view id) {
  const auto targets = exportTargets();
  const auto found = std::ranges::find(targets, id, &ExportTarget::id);
  return found == targets.end() ? nullptr : &*found;
}

void measureExport(ExportResult& made, std::shared_ptr<const Brdf> brdf,
                   const rendering::RenderedComparison& comparison, const TaskControl& control) {
  made.snr = comparison.signalToNoiseRatio(comparison.render(*brdf, control));
  made.brdf = std::move(brdf);
}

std::string originText(const materials::EditedMaterial& source, double snr) {
  char accuracy[80] = ". Rendered images are identical (comparison scene).";
  if (std::isfinite(snr)) std::snprintf(accuracy, sizeof accuracy, ". Rendered SNR %.1f dB (comparison scene).", snr);
  return materials::originOf(source) + accuracy;
}

std::string meanAzimuthWarning() {
  return "the material is anisotropic: the export contains the mean over all azimuths";
}

SurfaceValues writtenValues(SurfaceValues values) {
  constexpr double noEffect = 1e-3;
  if (values.coat < noEffect) values.coat = 0;
  if (maxChannel(values.sheenColour) < noEffect) values.sheenColour = Rgb(0);
  if (values.anisotropy < noEffect) values.anisotropy = 0;
  values.rotation = values.anisotropy > 0 ? values.rotation - pi * std::floor(values.rotation / pi) : 0;
  return values;
}

ExportResult makeSurfaceExport(const SurfaceShader& shader, std::string_view suffix, SurfaceText text,
                               const materials::EditedMaterial& source, const ExportOptions& options,
                               const TaskControl& control) {
  const rendering::RenderedComparison comparison = materials::comparisonOf(source, options, control.between(0, 0.15));
  const SurfaceValues values = writtenValues(fitSurface(shader, *source.shown.brdf, control.between(0.15, 0.85)));
  ExportResult made;
  measureExport(made, shader.brdf(values), comparison, control.between(0.85, 1));
  made.facts = {{"metalness", "Metalness", values.metalness},
                {"roughness", "Roughness", values.roughness},
                {"coat", "Coat", values.coat}};
  if (!source.shown.brdf->isIsotropic() && !shader.isFitted(SurfaceField::anisotropy))
    made.warnings.push_back(meanAzimuthWarning());
  made.parts.push_back(textPart(suffix, text(values, materials::plainName(source), originText(source, made.snr))));
  return made;
}

std::pair<ExportResult, ReciprocalLobes> makeLobesExport(std::span<const std::size_t> counts, LobesFormula formula,
                                                         const materials::EditedMaterial& source,
                                                         const ExportOptions& options, const TaskControl& control) {
  constexpr double rendered = 0.1;
  const rendering::RenderedComparison comparison =
      materials::comparisonOf(source, options, control.between(0, rendered));
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
