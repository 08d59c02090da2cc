// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/materials/material.h"

/// The near-measured copies of the bundled library: neural fits (Sztrajman et al. 2021, NeuralBrdf) of materials of the
/// MERL, RGL and DTU databases, of which the measurements themselves may not be shipped or are not at hand. Smoother
/// than the originals: no sensor noise, highlights a little rounder (resources/ATTRIBUTIONS.md).
namespace gonio::materials {

/// MaterialSource::format of a copy.
inline constexpr std::string_view nearMeasuredFormat = "near-measured copy";

struct NearMeasuredMaterial {
  std::string source;                 ///< merlCopySource, rglCopySource or dtuCopySource
  std::string name;                   ///< "alum-bronze"
  std::optional<double> renderedSnr;  ///< dB, against the measured file, where that is at hand
  std::span<const float> weights;     ///< NeuralBrdf::weightCount

  /// "near-measured copy of MERL alum-bronze: neural fit, Sztrajman et al. 2021", with the SNR where it is known.
  std::string description() const;
  /// Of the weights.
  std::string sha256() const;
};

/// All of them, in the order of the list.
const std::vector<NearMeasuredMaterial>& nearMeasuredMaterials();

/// Whether the material is bundled as it was measured, too: then nothing is learned from the copy.
bool isMeasuredToo(const NearMeasuredMaterial& copy);

/// The network as a table of the MERL grid. About 0.2 s on two cores. @throws Cancelled.
Material nearMeasuredMaterial(const NearMeasuredMaterial& copy, const TaskControl& control = {});

}  // namespace gonio::materials
