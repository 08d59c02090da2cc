// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/document/loaded_material.h"
#include "core/dictionary/encode.h"
#include "core/materials/dictionary_file.h"
#include "widgets/panels/fact_list.h"
#include "widgets/preview/gl/code_texels.h"

namespace gonio::app {

/// A material as a sparse code over the bundled dictionary, with what it costs and what it loses: measured, here and
/// now, of what its file would hold.
struct MaterialCode {
  LoadedMaterialPtr material;
  std::shared_ptr<const materials::NamedEnsemble> dictionary;
  std::size_t coefficients = 0;  ///< per channel, as they were asked for
  dictionary::Encoded encoded;
  std::shared_ptr<const widgets::EnsembleCode> stored;  ///< what the file holds, which is rounded
  std::shared_ptr<const TabulatedBrdf> table;           ///< decoded from `stored`
  std::shared_ptr<const TabulatedLobe> lobe;            ///< of the decoded table
  std::size_t bytes = 0;                                ///< of the file
  double logError = 0;                                  ///< metrics::BrdfMetric::log against the measurement
  double snr = 0;                                       ///< dB, of the reflectances
  double nanoseconds = 0;                               ///< of an evaluation straight from the code, on one core
  double decodeSeconds = 0;
};

/// Encodes over the bundled dictionary (some 2 s on two cores; the first call prepares the encoder before), decodes
/// what a file would hold, and measures that. From any thread. @throws Error when the material's grid is not the
/// dictionary's; Cancelled.
MaterialCode encodeMaterial(const LoadedMaterialPtr& material, std::size_t coefficients,
                            const TaskControl& control = {});

/// What the representation section shows of a code: error, bytes, time; which transform and dictionaries, and why.
std::vector<widgets::Fact> codeFacts(const MaterialCode& code);

}  // namespace gonio::app
