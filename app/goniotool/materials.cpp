// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/materials.h"

#include <chrono>
#include <cmath>

#include "core/io/sha256.h"
#include "core/materials/material_formats.h"
#include "core/rgl/rgl_edit.h"
#include "core/study/training_files.h"
#include "core/support/error.h"

namespace gonio::tool {

study::LearnedBasis basisOfSources(const std::vector<std::string>& sources, const std::vector<std::string>& excluded,
                                   int components, const Tool& tool, materials::BasisPrecision precision,
                                   const std::string& materialClass) {
  const std::vector<std::string> files =
      study::filesOfClass(study::trainingFilesOrLibrary(sources, excluded), study::materialClassNamed(materialClass),
                          tool.control("classifying the training materials"));
  return study::learnedBasis(files, components, precision,
                             tool.control("learning from " + std::to_string(files.size()) + " materials"));
}

void addClassOption(CLI::App& command, std::string& materialClass) {
  command
      .add_option("--class", materialClass, "Use only the training materials of a class: all, diffuse or glossy (all)")
      ->check(
          CLI::IsMember(std::vector<std::string>(study::materialClassNames.begin(), study::materialClassNames.end())));
}

std::string trainingSetHelp(const std::string& title) {
  return title + ": " + materials::suffixText(materials::isMeasurement, "or") + " files, or folders of them";
}

std::filesystem::path basisBeside(const std::string& plan) {
  return std::filesystem::path(plan).replace_extension(materials::basisSuffix);
}

std::string basisDigest(const std::filesystem::path& basis) {
  return withFileInErrors(basis, [&] { return io::sha256Hex(io::FileSource(basis)).substr(0, digestLength); });
}

Json WrittenMaterial::json() const {
  if (bytes == 0) return nullptr;
  Json json{{"snr", decibelsJson(snr)}, {"brdfSnr", decibelsJson(brdfSnr)}};
  addCost(json, cost);
  json["losses"] = losses;
  return json;
}

std::string outputHelp(const std::string& what) { return what + " (" + materials::writableSuffixText() + ")"; }

WrittenMaterial writeMaterial(const materials::EditedMaterial& material, const std::string& out, const Tool& tool,
                              const materials::EncodeOptions& options) {
  const materials::Encoded made = materials::writeMaterial(material, out, options, tool.control("writing"));
  WrittenMaterial written{made.bytes.size(), made.snr, made.brdfSnr, {}, made.losses, {}};
  written.cost = study::measureUse(*made.readBack, tool.control("measuring"));
  if (std::isfinite(made.snr))
    written.text = "  rendered SNR " + number(made.snr) + " dB, BRDF SNR " + number(made.brdfSnr) + " dB\n";
  written.text += "  " + costText(written.cost) + "\n";
  for (const std::string& loss : made.losses) written.text += "  note: " + loss + "\n";
  const materials::MaterialFormat& format = materials::writableFormat(out, *material.shown.brdf, options);
  if (const std::string text = materials::shortfall(made, format, options); !text.empty())
    written.text += "  warning: " + text + "\n";
  return written;
}

WrittenMaterial writeMaterial(const std::string& name, std::shared_ptr<const Brdf> brdf, const std::string& out,
                              const Tool& tool, const std::optional<HalfDifferenceGrid>& grid) {
  return writeMaterial(materials::unedited(name, std::move(brdf)), out, tool, {.grid = grid});
}

int averagedAzimuths(const Brdf& material, const std::string& out) {
  const bool holds = material.isIsotropic() || materials::writableFormat(out, material).holds.anisotropic;
  return holds ? 0 : editing::bakedAzimuths;
}

std::shared_ptr<const Brdf> openAtWavelength(const std::string& argument, double nanometres,
                                             const TaskControl& control) {
  if (nanometres == 0) return documents::openMaterial(argument, control).brdf;
  const materials::EditedMaterial opened = documents::openWithEdits(argument, control);
  const RglBrdf* file = formOf<RglBrdf>(*opened.base.brdf);
  if (!file || !file->tables()->data.spectra)
    throw Error(argument + ": found a material without spectra, expected a spectral RGL file for --wavelength");
  std::shared_ptr<const Brdf> edited;
  if (!editing::isIdentity(opened.edits))
    edited = editing::applyEdits(file->withIncident(IncidentDirection::viewer), opened.edits);
  return rgl::atWavelength(*file, edited.get(), nanometres, control);
}

}  // namespace gonio::tool
