// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// gonio_studies rgl_export [--size THETA_COUNT SIZE] [MATERIAL ...]: the rendered SNR, size and time of RGL files of
// edited materials (controls of the model ggx, as goniotool edit --model ggx --control NAME=VALUE), for Mitsuba and for
// pbrt, beside what the nodes of the source give. Without materials: the near-measured copies, unedited.
#include <chrono>
#include <cstdlib>
#include <string>

#include "core/fitting/fit.h"
#include "core/formats/rgl.h"
#include "core/materials/encode.h"
#include "core/models/registry.h"
#include "core/study/study_record.h"
#include "tests/studies/study_program.h"

namespace gonio::study::rgl_export_study {
namespace {

struct EditRow {
  const char* name;
  editing::ArtistControl control;
  Rgb value;
};
using enum editing::ArtistControl;
const EditRow editRows[] = {{"roughness x 1/4", roughness, Rgb(0.25)}, {"roughness x 1/2", roughness, Rgb(0.5)},
                            {"roughness x 2", roughness, Rgb(2)},      {"roughness x 4", roughness, Rgb(4)},
                            {"tint", tint, Rgb(1, 0.5, 0.25)},         {"contrast x 4", contrast, Rgb(4)}};

materials::EditedMaterial edited(const materials::Material& material, const models::Model& model,
                                 const models::ParameterValues& fitted, const EditRow& row) {
  editing::DifferentialEdit change{.model = &model, .fitted = fitted, .edited = fitted};
  change.composition = editing::defaultComposition(model);
  change.controls.values[std::size_t(row.control)] = row.value;
  materials::EditedMaterial result = materials::unedited(material);
  result.edits = {editing::Edit{change}};
  result.shown = materials::withEdits(material, result.edits);
  return result;
}

struct Tally {
  std::vector<double> ratios, bytes, seconds;

  void add(const char* name, const std::string& edit, const materials::EditedMaterial& material,
           const materials::EncodeOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    const rgl::EncodedRgl file = formats::encodeRgl(material, options);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    std::printf("%s,%s,%.1f,%.1f,%zu x %zu%s,%zu,%.1f\n", name, edit.c_str(), file.rgbSnr, file.spectralSnr,
                file.size.thetaCount, file.size.size, file.ownParameterisation ? " (source)" : "", file.rgb.size(),
                taken.count());
    std::fflush(stdout);
    for (const double ratio : {file.rgbSnr, file.spectralSnr}) ratios.push_back(ratio);
    bytes.push_back(double(file.rgb.size()));
    seconds.push_back(taken.count());
  }
};

int study(int argumentCount, char** arguments) {
  materials::EncodeOptions options;
  std::vector<std::string> names(arguments + 1, arguments + argumentCount);
  if (names.size() > 2 && names[0] == "--size") {
    options.size = {std::size_t(std::stoi(names[1])), std::size_t(std::stoi(names[2]))};
    names.erase(names.begin(), names.begin() + 3);
  }
  const bool copies = names.empty();
  if (copies)
    for (const materials::LibraryEntry& entry : materials::bundledLibrary())
      if (entry.origin == materials::LibraryOrigin::nearMeasured) names.push_back("library:" + entry.id);
  const models::Model& model = models::findModel("ggx");
  Tally tally;
  std::printf(
      "material,edit,rendered SNR of the RGB file (dB),of the spectral file (dB),nodes,bytes of the RGB "
      "file,seconds\n");
  for (const std::string& name : names) {
    const materials::Material material = materials::readMaterial(name);
    if (copies) {
      tally.add(name.c_str(), "none", materials::unedited(material), options);
      continue;
    }
    const models::ParameterValues fitted =
        fitting::fit(fitting::fitBase(material.brdf, material.tabulated()), model, {}).parameters;
    for (const EditRow& row : editRows)
      tally.add(material.name.c_str(), row.name, edited(material, model, fitted, row), options);
  }
  std::printf("# %zu files: rendered SNR at least %.1f, median %.1f dB; median %.0f bytes; at most %.1f s\n",
              tally.ratios.size(), quantile(tally.ratios, 0), quantile(tally.ratios, 0.5), quantile(tally.bytes, 0.5),
              quantile(tally.seconds, 1));
  return 0;
}

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::rgl_export_study
