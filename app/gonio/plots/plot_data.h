// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <optional>

#include "app/gonio/document/loaded_material.h"
#include "core/editing/edit.h"
#include "core/plots/plotted_values.h"
#include "widgets/plots/plot_series.h"

namespace gonio::app {

enum class PlotKind { polar, cartesian, slice, albedo, lobe };
inline constexpr PlotKind allPlotKinds[] = {PlotKind::polar, PlotKind::cartesian, PlotKind::slice, PlotKind::albedo,
                                            PlotKind::lobe};

/// A model fitted to the material; without a model: the measurement.
struct PlottedFit {
  const models::Model* model = nullptr;
  models::ParameterValues parameters = {};

  bool operator==(const PlottedFit&) const = default;
};

/// The albedo curves that do not depend on edits. They take longest and are reused while a slider moves.
struct KnownAlbedo {
  LoadedMaterialPtr material;
  std::shared_ptr<const Brdf> base;
  bool coarse = false;
  std::vector<std::pair<PlottedFit, plots::Curve>> curves;
};

/// Input of computePlot(): one kind of plot of a material and its edits.
struct PlotRequest {
  PlotKind kind = PlotKind::polar;
  LoadedMaterialPtr material;
  editing::EditList edits;
  std::optional<editing::DifferentialEdit> fit;  ///< the edit to which the plotted fit belongs
  plots::Section section;  ///< contains also the angle of incidence, phi_d and the cosine of the other plots
  plots::ThetaHSpacing spacing = plots::ThetaHSpacing::squareRoot;
  plots::SliceCoordinates coordinates = plots::SliceCoordinates::halfDifference;
  bool coarse = false;  ///< albedo with few samples, during an interaction
  std::shared_ptr<const KnownAlbedo> known;
  std::shared_ptr<const Brdf> base = nullptr;  ///< Document::base(); null: that of the material
  std::vector<PlottedFit> otherFits = {};      ///< in addition to `fit`
};

/// Series of the requested kind: measured (in its native form), fit (the model with the fitted parameters), the other
/// fits, and edited (if the edits have an effect).
struct PlotData {
  widgets::PlotSeriesList<plots::Curve> curves;
  widgets::PlotSeriesList<plots::Slice> slices;
  widgets::PlotSeriesList<plots::LobeSurface> lobes;
  std::shared_ptr<const KnownAlbedo> known;
};

/// Takes a few ms; for the albedo up to a second. @throws Cancelled.
PlotData computePlot(const PlotRequest& request, const TaskControl& control = {});

}  // namespace gonio::app
