// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/encode_components.h"

#include <chrono>

#include "app/goniotool/factor_quality.h"
#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "core/brdf/weighted_sum.h"
#include "core/materials/basis_file.h"
#include "core/metrics/brdf_metrics.h"

namespace gonio::tool {

int encodeComponents(const ComponentArguments& options, const Tool& tool) {
  if (!options.out.empty()) materials::checkWritableSuffix(options.out);
  const auto file = materials::readBasis(options.basis);
  const dictionary::PrincipalComponents& basis = file->components;
  if (options.components > basis.count())
    throw Error(options.basis + ": found " + std::to_string(basis.count()) + " components, expected at least " +
                std::to_string(options.components) + "; use fewer --coefficients");
  const auto material = openMaterial(options.material, tool.control("reading"));
  const auto table =
      onGrid(material.tabulated(tool.control("tabulating")), basis.mapping.grid, tool.control("sampling"));
  const auto start = std::chrono::steady_clock::now();
  const dictionary::ComponentCode code =
      dictionary::encode(basis, *table, options.components, tool.control("encoding"));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto decoded = dictionary::decode(basis, code.inHalfPrecision(), tool.control("decoding"));
  const auto [errors, snr] = brdfQuality(*material.brdf, *decoded);
  const std::size_t bytes = dictionary::ComponentCode::halfBytes(code.components());
  Json json{{"method", "components"},       {"coefficients", code.components()}, {"bytes", bytes},
            {"errors", errorsJson(errors)}, {"brdfSnr", decibelsJson(snr)},      {"seconds", seconds}};
  const std::string tableText = addTableQuality(json, *material.brdf, *table);
  std::string writtenText;
  if (!options.out.empty()) {
    const WrittenMaterial written = writeMaterial(material.name, decoded, options.out, tool);
    json["written"] = written.json();
    json["out"] = options.out;
    writtenText = written.text;
  }
  print(tool, json,
        std::to_string(code.components()) + " components per channel, " + std::to_string(bytes) + " bytes, BRDF SNR " +
            number(snr) + " dB, " + number(seconds) + " s\n" + errorsText(errors) + tableText + writtenText);
  return 0;
}

}  // namespace gonio::tool
