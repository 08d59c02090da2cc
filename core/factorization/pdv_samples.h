// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>

#include "core/brdf/tabulated_brdf.h"
#include "core/factorization/masked_rank_one.h"
#include "core/factorization/pdv_factors.h"

namespace gonio::factorization {

/// What a PDV model is factorised from.
struct PdvSamples {
  std::array<MaskedTensor, 3> channels;  ///< red, green, blue: theta_R, |Dp|, |phi|; the same cells count in each
  std::size_t cells = 0;                 ///< that are on the disk and were measured
};

/// A table over the nodes of a PDV model, transformed, the mean of phi and -phi; in the form with two factors weighted
/// means over phi.
///
/// Curves are read between their nodes, so a model between the last node on the disk and the first off it takes half of
/// its value from a cell that holds no measurement. Left free, products of later terms grow without bound there.
/// Therefore cells beside such that count take their neighbours' mean, at a hundredth of their weight.
/// @param axes form, transform and nodes; its curves are not looked at. In parallel, deterministic.
/// @throws Cancelled.
PdvSamples samplePdv(const TabulatedBrdf& table, const PdvFactors& axes, PdvWeights weights,
                     const TaskControl& control = {});

}  // namespace gonio::factorization
