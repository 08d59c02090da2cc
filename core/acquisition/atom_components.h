// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/acquisition/dictionary_reconstruction.h"
#include "core/dictionary/principal_components.h"

namespace gonio::acquisition {

/// Number of atoms by default, unless more samples are chosen.
inline constexpr int defaultAtomSignals = 128;

/// The atoms of dictionaries as signals for selectSamples(), instead of the channels of training materials: each column
/// of X is an atom times the standard deviation of its coefficient in the prior, and X = U Sigma V^T without a mean, so
/// that X X^T is the covariance of the scaled signals that reconstructInDictionaries() assumes. The atoms with the
/// largest variances of all dictionaries together are used. Cells are those whose directions are above the horizon.
/// The result serves the choice of directions alone: its mapping has no reference values, so that encode(), decode()
/// and reconstruct() make no sense.
/// @param atoms number of columns: 4 bytes x cells each. @throws Error if the prior belongs to another ensemble or
/// fewer than one atom is requested; Cancelled.
dictionary::PrincipalComponents atomComponents(const dictionary::Ensemble& ensemble, const DictionaryPrior& prior,
                                               int atoms = defaultAtomSignals, const TaskControl& control = {});

}  // namespace gonio::acquisition
