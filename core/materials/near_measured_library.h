// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/materials/material.h"

/// The near-measured copies of the bundled library: neural fits (Sztrajman et al. 2021, NeuralBrdf) of materials of the
/// MERL, RGL and DTU databases, for measurements that may not be redistributed or are not available. They are smoother
/// than the originals, without sensor noise and with slightly rounder highlights (resources/ATTRIBUTIONS.md).
namespace gonio::materials {

/// MaterialSource::format of a copy.
inline constexpr std::string_view nearMeasuredFormat = "near-measured copy";

struct NearMeasuredMaterial {
  std::string source;                 ///< merlCopySource, rglCopySource or dtuCopySource
  std::string name;                   ///< e.g. "alum-bronze"
  std::optional<double> renderedSnr;  ///< against the measured file, dB; empty if unknown
  std::span<const float> weights;     ///< NeuralBrdf::weightCount values

  /// For display: "near-measured copy of MERL alum-bronze: neural fit of the measurement, Sztrajman et al. 2021", with
  /// the SNR if known.
  std::string description() const;
  /// SHA-256 of the weights.
  std::string sha256() const;
};

/// All near-measured copies, in the order of libraryRows().
const std::vector<NearMeasuredMaterial>& nearMeasuredMaterials();

/// Whether the measured material is bundled too; then training sets exclude the copy.
bool isOriginalBundled(const NearMeasuredMaterial& copy);

/// Evaluates the network on the MERL grid. About 0.2 s on two cores. @throws Cancelled.
Material nearMeasuredMaterial(const NearMeasuredMaterial& copy, const TaskControl& control = {});

}  // namespace gonio::materials
