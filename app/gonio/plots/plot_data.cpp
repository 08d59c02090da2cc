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

/// One of the up to three reflectances that a plot shows.
struct Source {
  SeriesRole role;
  QString name;
  std::shared_ptr<const Brdf> brdf;
  const TabulatedBrdf* coverage;  ///< null: defined everywhere
};

std::vector<Source> sourcesOf(const PlotRequest& request) {
  const auto& base = request.base ? request.base : request.material->base;
  const TabulatedBrdf* table = base->asTable();
  std::vector<Source> sources{{SeriesRole::measured, sourceKind(*request.material).toLower(), base, table}};
  if (request.fit) {
    const models::Model& model = *request.fit->model;
    sources.push_back({SeriesRole::fit, QObject::tr("fit (%1)").arg(widgets::fromView(model.spec().name)),
                       model.instantiate(request.fit->fitted), nullptr});
  }
  if (!editing::isIdentity(request.edits))
    sources.push_back({SeriesRole::edited, QObject::tr("edited"), editing::applyEdits(base, request.edits), table});
  return sources;
}

bool isKnown(const PlotRequest& request) {
  const KnownAlbedo* known = request.known.get();
  return known && known->material == request.material && known->base == request.base &&
         known->coarse == request.coarse && request.fit && known->model == request.fit->model &&
         known->fitted == request.fit->fitted;
}

void computeAlbedo(const PlotRequest& request, const std::vector<Source>& sources, PlotData& data,
                   const TaskControl& control) {
  const bool known = isKnown(request);
  auto kept = std::make_shared<KnownAlbedo>();
  if (known) *kept = *request.known;
  for (const Source& source : sources) {
    plots::Curve curve;
    if (known && source.role != SeriesRole::edited)
      curve = source.role == SeriesRole::measured ? kept->measured : kept->fit;
    else
      curve = plots::albedoCurve(*source.brdf, request.coarse ? coarseAngles : fineAngles,
                                 request.coarse ? coarseSamples : fineSamples, control);
    if (source.role == SeriesRole::measured) kept->measured = curve;
    if (source.role == SeriesRole::fit) kept->fit = curve;
    data.curves.push_back({source.role, source.name, std::move(curve)});
  }
  kept->material = request.material;
  kept->base = request.base;
  kept->coarse = request.coarse;
  if (request.fit) {
    kept->model = request.fit->model;
    kept->fitted = request.fit->fitted;
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
  for (const auto& [role, name, brdf, coverage] : sources) {
    control.throwIfStopped();
    if (request.kind == PlotKind::polar)
      data.curves.push_back({role, name, plots::polarLobe(*brdf, section.thetaI, section.cosine, coverage)});
    else if (request.kind == PlotKind::cartesian)
      data.curves.push_back({role, name, plots::sectionCurve(*brdf, section, coverage)});
    else if (request.kind == PlotKind::slice)
      data.slices.push_back(
          {role, name, plots::halfDifferenceSlice(*brdf, section.phiD, request.spacing, section.cosine, coverage)});
    else
      data.lobes.push_back({role, name, plots::lobeSurface(*brdf, section.thetaI, section.cosine, coverage)});
  }
  return data;
}

}  // namespace gonio::app
