// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <optional>

#include "app/gonio/document/loaded_material.h"
#include "core/editing/edit.h"
#include "core/plots/albedo_curve.h"
#include "core/plots/lobe_surface.h"
#include "core/plots/section.h"
#include "core/plots/slice.h"
#include "widgets/plots/plot_series.h"

namespace gonio::app {

enum class PlotKind { polar, cartesian, slice, albedo, lobe };
inline constexpr PlotKind allPlotKinds[] = {PlotKind::polar, PlotKind::cartesian, PlotKind::slice, PlotKind::albedo,
                                            PlotKind::lobe};

/// A model as it was fitted to the material; no model: the measurement.
struct PlottedFit {
  const models::Model* model = nullptr;
  models::ParameterValues parameters = {};

  bool operator==(const PlottedFit&) const = default;
};

/// The albedo curves that an edit leaves as they are: they take longest and are kept while a slider moves.
struct KnownAlbedo {
  LoadedMaterialPtr material;
  std::shared_ptr<const Brdf> base;
  bool coarse = false;
  std::vector<std::pair<PlottedFit, plots::Curve>> curves;
};

/// What to compute: one kind of plot of a material and its edits.
struct PlotRequest {
  PlotKind kind = PlotKind::polar;
  LoadedMaterialPtr material;
  editing::EditList edits;
  std::optional<editing::DifferentialEdit> fit;  ///< the one of them that the fit is of
  plots::Section section;                        ///< also the angle of incidence, phi_d and the cosine of the others
  plots::ThetaHSpacing spacing = plots::ThetaHSpacing::squareRoot;
  bool coarse = false;  ///< albedo: few samples, while something moves
  std::shared_ptr<const KnownAlbedo> known;
  std::shared_ptr<const Brdf> base = nullptr;  ///< Document::base(); null: that of the material
  std::vector<PlottedFit> otherFits = {};      ///< beside `fit`
};

/// Series of the kind that was asked for: measured (in its own form), fit (the model at the fitted parameters), the
/// other fits, edited (where the edit changes something).
struct PlotData {
  widgets::PlotSeriesList<plots::Curve> curves;
  widgets::PlotSeriesList<plots::Slice> slices;
  widgets::PlotSeriesList<plots::LobeSurface> lobes;
  std::shared_ptr<const KnownAlbedo> known;
};

/// Some ms; the albedo up to a second. @throws Cancelled.
PlotData computePlot(const PlotRequest& request, const TaskControl& control = {});

}  // namespace gonio::app
