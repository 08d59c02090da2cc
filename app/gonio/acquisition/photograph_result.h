// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QStringList>
#include <memory>
#include <string>
#include <vector>

#include "app/gonio/acquisition/photograph_inputs.h"
#include "core/photograph/photograph_fit.h"
#include "core/rendering/render_picture.h"
#include "core/study/training_files.h"
#include "widgets/acquisition/uncertainty_curve.h"

namespace gonio::app {

/// Training materials as photographs are reconstructed from them.
struct PhotographTraining {
  QStringList ids;
  study::MaterialClass materialClass = study::MaterialClass::all;
  std::shared_ptr<const dictionary::PrincipalComponents> basis;
  std::shared_ptr<const photograph::PhotographPrior> prior;
};

/// A material reconstructed from photographs, with what the panel shows of it.
struct PhotographResult {
  photograph::PhotographFit fit;
  std::shared_ptr<const TabulatedBrdf> table;
  QStringList paths;              ///< of the photographs
  std::vector<QImage> residuals;  ///< one per photograph, for widgets::ResidualView
  double residualRange = 0;       ///< relative difference in the last colours of all of them
  /// Of the reconstruction in the light of each photograph, as bright as its image; of other shapes as in the
  /// photograph.
  std::vector<QImage> spheres;
  QStringList lights;                                         ///< names of these lights
  std::vector<widgets::UncertaintyCurve::Point> uncertainty;  ///< one per half angle of the grid
};
using PhotographResultPtr = std::shared_ptr<const PhotographResult>;

/// Reconstructs a material: reads the images of all photographs, fits, and renders. @param training with its prior.
/// @param picture size and samples of the spheres. @throws Error, Cancelled.
PhotographResultPtr reconstructPhotographs(const PhotographTraining& training, const PhotographInputs& inputs,
                                           std::size_t maxRegions, const rendering::RenderOptions& picture,
                                           const TaskControl& control = {});

/// The residual of a photograph: (value - predicted) / predicted of the luminance of each region, NaN where the
/// prediction is black. One per region of the fit.
std::vector<double> relativeResiduals(const photograph::PhotographFit& fit);

/// A material on a sphere in a bundled environment, on a transparent ground. @throws Cancelled.
QImage sphereUnder(const TabulatedBrdf& table, const std::string& environment, const rendering::RenderOptions& picture,
                   const TaskControl& control = {});

}  // namespace gonio::app
