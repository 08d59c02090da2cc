// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/photograph/photograph_fit.h"

/// Materials from a photograph without learning, beside which fitPhotographs() is judged.
namespace gonio::study {

/// Pixel values of regions, to which the methods are fitted.
struct ImageData {
  std::vector<photograph::Region> regions;
  photograph::PixelRows rows;
  std::vector<DirectionPair> pairs;  ///< of the cells
};
ImageData imageData(const photograph::PhotographPrior& prior, const photograph::PhotographSet& set);

/// The GGX model, and the layered lobes, that best reproduce the photograph.
std::shared_ptr<const Brdf> fittedGgx(const ImageData& data);
std::shared_ptr<const Brdf> fittedLobes(const ImageData& data);
/// The training material that best reproduces it, except `left`. @param names, tables of the training materials.
/// @param name result: that of the material.
std::shared_ptr<const Brdf> nearest(const ImageData& data, const photograph::PhotographPrior& prior,
                                    std::span<const std::string> names,
                                    std::span<const std::shared_ptr<const TabulatedBrdf>> tables,
                                    const std::string& left, std::string& name);

}  // namespace gonio::study
