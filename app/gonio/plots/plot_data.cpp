// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/plots/plot_data.h"

#include <QObject>
#include <algorithm>

#include "app/gonio/document/loaded_material.h"
#include "core/models/model.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {

using widgets::SeriesRole;

constexpr int fineAngles = 31, fineSamples = 1 << 14, coarseAngles = 19, coarseSamples = 1 << 9;

/// One of the reflectances that a plot shows.
struct Source {
  SeriesRole role;
  QString name;
  std::shared_ptr<const Brdf> brdf;
  const TabulatedBrdf* coverage;  ///< null: defined everywhere
  std::optional<PlottedFit> fit;  ///< what it is while edits change; none: the edited material
};

Source fitSource(SeriesRole role, const PlottedFit& fit) {
  return {role, QObject::tr("fit (%1)").arg(widgets::toQString(fit.model->spec().name)),
          fit.model->instantiate(fit.parameters), nullptr, fit};
}

std::vector<Source> sourcesOf(const PlotRequest& request) {
  const auto& base = request.base ? request.base : request.material->base;
  const TabulatedBrdf* table = formOf<TabulatedBrdf>(*base);
  std::vector<Source> sources{
      {SeriesRole::measured, sourceKind(*request.material).toLower(), base, table, PlottedFit{}}};
  const models::Model* used = request.fit ? request.fit->model : nullptr;
  if (used) sources.push_back(fitSource(SeriesRole::fit, {used, request.fit->fitted}));
  int number = 0;
  for (const PlottedFit& other : request.otherFits)
    if (other.model != used) sources.push_back(fitSource(widgets::otherFit(number++), other));
  if (!editing::isIdentity(request.edits))
    sources.push_back({SeriesRole::edited, QObject::tr("edited"), editing::applyEdits(base, request.edits), table, {}});
  return sources;
}

const plots::Curve* knownCurve(const PlotRequest& request, const Source& source) {
  const KnownAlbedo* known = request.known.get();
  if (!known || !source.fit || known->material != request.material || known->base != request.base ||
      known->coarse != request.coarse)
    return nullptr;
  const auto found = std::ranges::find(known->curves, *source.fit, &std::pair<PlottedFit, plots::Curve>::first);
  return found == known->curves.end() ? nullptr : &found->second;
}

void computeAlbedo(const PlotRequest& request, const std::vector<Source>& sources, PlotData& data,
                   const TaskControl& control) {
  auto kept = std::make_shared<KnownAlbedo>(KnownAlbedo{request.material, request.base, request.coarse, {}});
  for (const Source& source : sources) {
    const plots::Curve* known = knownCurve(request, source);
    plots::Curve curve = known ? *known
                               : plots::albedoCurve(*source.brdf, request.coarse ? coarseAngles : fineAngles,
                                                    request.coarse ? coarseSamples : fineSamples, control);
    if (source.fit) kept->curves.emplace_back(*source.fit, curve);
    data.curves.push_back({source.role, source.name, std::move(curve)});
  }
  data.known = std::move(kept);
}

}  // namespace

PlotData computePlot(const PlotRequest& request, const TaskControl& control) {
  PlotData data;
  data.known = request.known;
  const std::vector<Source> sources = sourcesOf(request);
  const plots::Section& section = request.section;
  if (request.kind == PlotKind::albedo) {
    computeAlbedo(request, sources, data, control);
    return data;
  }
  for (const auto& [role, name, brdf, coverage, fit] : sources) {
    control.throwIfStopped();
    if (request.kind == PlotKind::polar)
      data.curves.push_back({role, name, plots::polarLobe(*brdf, section.thetaI, section.cosine, coverage)});
    else if (request.kind == PlotKind::cartesian)
      data.curves.push_back({role, name, plots::sectionCurve(*brdf, section, coverage)});
    else if (request.kind == PlotKind::slice)
      data.slices.push_back(
          {role, name,
           plots::sliceOf(*brdf, request.coordinates, section.phiD, request.spacing, section.cosine, coverage)});
    else
      data.lobes.push_back({role, name, plots::lobeSurface(*brdf, section.thetaI, section.cosine, coverage)});
  }
  return data;
}

}  // namespace gonio::app
