// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/materials/material.h"
#include "core/models/model.h"

/// The bundled materials, which bundledLibrary() lists: their list is resources/library/materials.csv, and their data
/// are compiled into the program in the order of the list.
namespace gonio::materials {

/// Sources of the materials in resources/library: the prefixes of their ids.
inline constexpr std::string_view rglSource = "rgl", merlCopySource = "merl-copy", rglCopySource = "rgl-copy",
                                  dtuCopySource = "dtu-copy", sgdSource = "sgd";

inline constexpr std::string_view libraryScheme = "library:";

/// The file of the measured material of a path "library:rgl/NAME". @throws Error for other paths.
std::vector<std::byte> bundledFile(const std::string& path);

/// MaterialSource::sha256 of the material of a library path, without reading it; empty if there is no such material.
std::string librarySha256(const std::string& path);

/// Paths of the default training set, each material once: the measured ones, then near-measured copies of materials
/// that are not among them. No published fits.
std::vector<std::string> libraryTrainingPaths();

/// The material of a path such as "library:rgl/NAME" (MeasuredMaterial), "library:merl-copy/NAME"
/// (NearMeasuredMaterial) or "library:sgd/NAME" (SgdFit).
/// @throws Error if there is no material of this name; Cancelled.
Material readLibraryMaterial(const std::string& path, const TaskControl& control = {});

/// A measured material: a file of the RGL database (Dupuy and Jakob 2018, CC0) in its own adaptive parameterisation,
/// without the fields that can be computed (scripts/bundle_rgl.py; resources/ATTRIBUTIONS.md).
struct MeasuredMaterial {
  std::string name;                 ///< e.g. "cc_iris_purple_gem"
  std::span<const std::byte> file;  ///< an RGL file

  /// For display, e.g. "RGL, measured: TeckWrap vinyl wrapping film (Iris Purple Gem RD03)".
  std::string description() const;
  /// SHA-256 of the file.
  std::string sha256() const;
};

/// All measured materials, in the order of the list.
const std::vector<MeasuredMaterial>& measuredMaterials();

/// Reads the material. About 12 ms.
Material measuredMaterial(const MeasuredMaterial& measured);

/// MaterialSource::format of a copy.
inline constexpr std::string_view nearMeasuredFormat = "near-measured copy";

/// A near-measured copy: a neural fit (Sztrajman et al. 2021, NeuralBrdf) of a material of the MERL, RGL and DTU
/// databases, for measurements that may not be redistributed or are not available. Copies are smoother than the
/// originals, without sensor noise and with slightly rounder highlights (resources/ATTRIBUTIONS.md).
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

/// All near-measured copies, in the order of the list.
const std::vector<NearMeasuredMaterial>& nearMeasuredMaterials();

/// Whether the measured material is bundled too; then training sets exclude the copy.
bool isOriginalBundled(const NearMeasuredMaterial& copy);

/// Evaluates the network on the MERL grid. About 0.2 s on two cores. @throws Cancelled.
Material nearMeasuredMaterial(const NearMeasuredMaterial& copy, const TaskControl& control = {});

/// The published table of parameters, CSV with a header line, compiled into the program.
std::string_view sgdTableCsv();

/// MaterialSource::format of a fit.
inline constexpr std::string_view sgdFormat = "SGD fit";

/// A published SGD fit of one of the 100 MERL materials (Bagher et al. 2012; resources/ATTRIBUTIONS.md).
struct SgdFit {
  std::string name;                    ///< e.g. "chrome"
  models::ParameterValues parameters;  ///< parameters of the model "sgd"

  std::string description() const;  ///< "SGD fit of MERL chrome, Bagher et al. 2012"
  std::string sha256() const;       ///< of the parameters as JSON
};

/// Parses the table. @throws Error that names the line and the column.
std::vector<SgdFit> parseSgdTable(std::string_view csv);

/// The bundled fits, parsed once.
const std::vector<SgdFit>& sgdFits();

/// A fit as a material.
Material sgdMaterial(const SgdFit& fit);

}  // namespace gonio::materials
