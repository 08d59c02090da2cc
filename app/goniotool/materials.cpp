// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/materials.h"

#include <cmath>

#include "core/rgl/rgl_edit.h"

namespace gonio::tool {

Json WrittenMaterial::json() const {
  if (bytes == 0) return nullptr;
  return {{"snr", decibelsJson(snr)}, {"brdfSnr", decibelsJson(brdfSnr)}, {"losses", losses}};
}

std::string outputHelp(const std::string& what) { return what + " (" + materials::writableSuffixText() + ")"; }

WrittenMaterial writeMaterial(const materials::EditedMaterial& material, const std::string& out, const Tool& tool,
                              const materials::EncodeOptions& options) {
  const materials::Encoded made = materials::writeMaterial(material, out, options, tool.control("writing"));
  WrittenMaterial written{made.bytes.size(), made.snr, made.brdfSnr, made.losses, {}};
  if (std::isfinite(made.snr))
    written.text = "  rendered SNR " + number(made.snr) + " dB, BRDF SNR " + number(made.brdfSnr) + " dB\n";
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
  if (nanometres == 0) return openMaterial(argument, control).brdf;
  const materials::EditedMaterial opened = editing::openWithEdits(argument, control);
  const RglBrdf* file = formOf<RglBrdf>(*opened.base.brdf);
  if (!file || !file->tables()->data.spectra)
    throw Error(argument + ": found a material without spectra, expected a spectral RGL file for --wavelength");
  std::shared_ptr<const Brdf> edited;
  if (!editing::isIdentity(opened.edits))
    edited = editing::applyEdits(file->withIncident(IncidentDirection::viewer), opened.edits);
  return rgl::atWavelength(*file, edited.get(), nanometres, control);
}

}  // namespace gonio::tool
