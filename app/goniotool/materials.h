// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/documents/open_material.h"
#include "core/materials/encode.h"
#include "core/study/learned_basis.h"
#include "core/study/training_files.h"

namespace gonio::tool {

/// study::learnedBasis() of the materials of study::trainingFilesOrLibrary() of a class.
study::LearnedBasis basisOfSources(const std::vector<std::string>& sources, const std::vector<std::string>& excluded,
                                   int components, const Tool& tool, materials::BasisPrecision precision,
                                   const std::string& materialClass = std::string(study::materialClassNames[0]));

/// Adds the option --class, the class of the training materials.
void addClassOption(CLI::App& command, std::string& materialClass);

/// The help of an option that names training materials, e.g. "Training set: .binary, .bsdf or .bin files, or folders of
/// them"; `title` is the part before the colon.
std::string trainingSetHelp(const std::string& title);

/// Path of a plan's basis, beside the plan: PLAN.basis for PLAN.csv.
std::filesystem::path basisBeside(const std::string& plan);

/// Identifies the basis in a plan: the first characters of the file's SHA-256. @throws Error that names the file.
inline constexpr std::size_t digestLength = 16;
std::string basisDigest(const std::filesystem::path& basis);

inline constexpr const char* materialHelp = "A material: a file, a .gonio document, or library:SOURCE/NAME";

using documents::isDocument;
using documents::openMaterial;

/// For help texts: ".pdv".
inline std::string suffixOf(const materials::MaterialFormat& format) { return std::string(format.suffix()); }
/// The help of an option that names a material to write: "The material (.binary, .bsdf or .bin)".
std::string outputHelp(const std::string& what);

/// What a written file lost; `bytes` is 0 if none was written.
struct WrittenMaterial {
  std::size_t bytes = 0;
  double snr = 0, brdfSnr = 0;  ///< dB
  study::UseCost cost;          ///< of the file, read back
  std::vector<std::string> losses;
  std::string text;  ///< a line each

  /// Keys snr, brdfSnr, evaluationNs, frameMs, losses; null if no file was written.
  Json json() const;
};
/// Writes a material with materials::writeMaterial(). @throws Error that names the file.
WrittenMaterial writeMaterial(const materials::EditedMaterial& material, const std::string& out, const Tool& tool,
                              const materials::EncodeOptions& options = {});
/// The same for the result of a method. @param grid of the table that the method worked on, for MERL files.
WrittenMaterial writeMaterial(const std::string& name, std::shared_ptr<const Brdf> brdf, const std::string& out,
                              const Tool& tool, const std::optional<HalfDifferenceGrid>& grid = {});

/// Number of azimuths that a file of this name contains the mean of; 0 if it holds the material's dependence on them.
int averagedAzimuths(const Brdf& material, const std::string& out);

/// Opens a material argument at one wavelength, nm, as three equal channels; 0: as openMaterial(). @throws Error that
/// names a file without spectra.
std::shared_ptr<const Brdf> openAtWavelength(const std::string& argument, double nanometres,
                                             const TaskControl& control = {});
inline constexpr const char* wavelengthHelp =
    "Wavelength in nm: use only this one of a spectral RGL file, as grey values (all wavelengths under D65)";

}  // namespace gonio::tool
