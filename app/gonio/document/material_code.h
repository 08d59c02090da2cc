// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

#include "app/gonio/document/loaded_material.h"
#include "core/brdf/data_transform.h"
#include "core/dictionary/encode.h"
#include "core/materials/dictionary_file.h"
#include "core/study/accuracy_study.h"
#include "widgets/panels/fact_list.h"
#include "widgets/preview/gl/code_decoder.h"

namespace gonio::app {

/// Formula of a transform, e.g. "ln(1 + ρ)", with the BRDF value ρ in 1/sr.
QString transformFormula(DataTransform transform);

/// A material as a sparse code with the bundled dictionary. Its cost and error are measured on this machine, for the
/// rounded code that a file stores.
struct MaterialCode {
  LoadedMaterialPtr material;
  std::shared_ptr<const materials::NamedEnsemble> dictionary;
  std::size_t coefficients = 0;  ///< per channel, as requested
  dictionary::EncodeResult encoded;
  std::shared_ptr<const widgets::EnsembleCode> stored;  ///< the rounded code of the file
  std::shared_ptr<const TabulatedBrdf> table;           ///< decoded from `stored`
  std::shared_ptr<const TabulatedDensity> density;      ///< sampling density of the decoded table
  std::size_t bytes = 0;                                ///< of the file
  study::MaterialQuality quality;                       ///< of `stored` against the measurement
  double decodeSeconds = 0;
  std::vector<std::string> warnings = {};  ///< dictionary::lostPeaks()
};

/// Encodes with the bundled dictionary (about 2 s on two cores; the first call also prepares the encoder), decodes the
/// content of the file and measures its error. Thread-safe. @throws Error if the grids of material and dictionary
/// differ; Cancelled.
MaterialCode encodeMaterial(const LoadedMaterialPtr& material, std::size_t coefficients,
                            const TaskControl& control = {});

/// The facts of a code for the representation section: error, bytes, time, transform and dictionaries, and the reason
/// for their choice.
std::vector<widgets::Fact> codeFacts(const MaterialCode& code);

}  // namespace gonio::app
