// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/material_formats.h"

#include <algorithm>
#include <array>

#include "core/io/astm_file.h"
#include "core/io/curet_file.h"
#include "core/io/format_mismatch.h"
#include "core/io/goniophotometer_file.h"
#include "core/io/lighttools_file.h"
#include "core/io/merl_file.h"
#include "core/io/rgl_file.h"
#include "core/io/tensor_file.h"
#include "core/io/utia_file.h"
#include "core/io/zemax_file.h"
#include "core/materials/code_file.h"
#include "core/materials/encode.h"
#include "core/materials/neural_file.h"
#include "core/materials/pdv_file.h"
#include "core/materials/scattered_material.h"
#include "core/support/lower_case.h"

namespace gonio::materials {

namespace {

template <bool reciprocal>
void sniffMerl(const io::ByteSource& source) {
  if (io::readMerlHeader(source).reciprocal != reciprocal)
    throw io::FormatMismatch(reciprocal ? "phi_d from 0 to 360 degrees" : "phi_d from 0 to 180 degrees",
                             reciprocal ? "0 to 180 degrees" : "0 to 360 degrees");
}

void readMerlMaterial(const io::ByteSource& source, const TaskControl& control, Material& material) {
  const io::MerlTable merl = io::readMerl(source, control);
  const HalfDifferenceGrid& grid = merl.table->grid();
  material.table = merl.table;
  material.brdf = merl.table;
  material.source.grid = {grid.thetaHCount, grid.thetaDCount, grid.phiDCount};
  if (merl.clampedCount > 0)
    material.source.notes.push_back(std::to_string(merl.clampedCount) + " small negative values were set to 0");
}

void readRglMaterial(const io::ByteSource& source, const TaskControl& control, Material& material) {
  control.throwIfStopped();
  io::RglFile rgl = io::readRgl(source);
  material.brdf = std::move(rgl.brdf);
  material.source.description = std::move(rgl.description);
  material.source.grid = std::move(rgl.grid);
  if (rgl.isSpectral)
    material.source.notes.push_back("spectra are converted to colours under D65 with the CIE 1931 observer");
  if (rgl.negativeCount > 0)
    material.source.notes.push_back(std::to_string(rgl.negativeCount) +
                                    " negative values (colours outside the sRGB gamut) are preserved");
}

void readUtiaMaterial(const io::ByteSource& source, const TaskControl& control, Material& material) {
  control.throwIfStopped();
  const auto utia = io::readUtia(source);
  material.brdf = utia;
  material.source.grid = {int(UtiaBrdf::polarCount), int(UtiaBrdf::azimuthCount), int(UtiaBrdf::polarCount),
                          int(UtiaBrdf::azimuthCount)};
  material.source.notes.push_back(
      "measured up to 75 degrees from the normal; beyond that, the value at 75 degrees is used");
  if (utia->clampedCount() > 0)
    material.source.notes.push_back(std::to_string(utia->clampedCount()) + " negative values were set to 0");
}

/// Of the formats of optical design programs.
template <io::IncidenceFile (*read)(const io::ByteSource& source)>
void readIncidenceMaterial(const io::ByteSource& source, const TaskControl& control, Material& material) {
  control.throwIfStopped();
  io::IncidenceFile file = read(source);
  const IncidenceTable& table = file.brdf->table();
  material.brdf = file.brdf;
  material.source.grid = {int(table.incident.size()), int(table.azimuths.size()), int(table.polars.size())};
  material.source.notes = std::move(file.notes);
  if (file.brdf->clampedCount() > 0)
    material.source.notes.push_back(std::to_string(file.brdf->clampedCount()) + " negative values were set to 0");
}

/// Of formats of single pairs of directions.
template <io::ScatteredSamples (*read)(const io::ByteSource& source)>
void readScatteredMaterial(const io::ByteSource& source, const TaskControl& control, Material& material) {
  control.throwIfStopped();
  setScattered(read(source), control, material);
}

void readPdvMaterial(const io::ByteSource& source, const TaskControl&, Material& material) {
  const factorization::PdvFactors factors = readPdv(source);
  material.brdf = factorization::makePdvBrdf(factors);
  material.source.grid = {int(factors.thetaNodes.size()), int(factors.deviationNodes.size()),
                          int(factors.phiNodes.size())};
  material.source.description = std::to_string(factors.terms()) + (factors.terms() == 1 ? " term of " : " terms of ") +
                                (factors.form == factorization::PdvForm::twoFactors ? "two" : "three") +
                                " factors, transform " +
                                std::string(dataTransformNames[std::size_t(factors.transform)]);
}

void readCodeMaterial(const io::ByteSource& source, const TaskControl&, Material& material) {
  setCode(readCode(source), material);
}

void readNeuralMaterial(const io::ByteSource& source, const TaskControl&, Material& material) {
  material.brdf = std::make_shared<const NeuralBrdf>(readNeural(source));
  material.source.grid = {int(NeuralBrdf::weightCount)};
  material.source.description = "network with two hidden layers of " + std::to_string(NeuralBrdf::hidden) + " units";
}

std::string gridText(const HalfDifferenceGrid& grid) {
  return std::to_string(grid.thetaHCount) + " x " + std::to_string(grid.thetaDCount) + " x " +
         std::to_string(grid.phiDCount);
}

std::string clippedText(std::size_t count) { return std::to_string(count) + " negative values were set to 0"; }

/// The table of a material with a grid that folds phi_d or does not; null if it has none.
std::shared_ptr<const TabulatedBrdf> ownTable(const EditedMaterial& material, bool reciprocal,
                                              const TaskControl& control) {
  const auto& [shown, base] = std::tie(material.shown, material.base);
  if (shown.table && shown.table->grid().reciprocal == reciprocal) return shown.table;
  if (!base.table || base.table->grid().reciprocal != reciprocal) return nullptr;
  // Cell by cell: cells without data keep none.
  return editing::bakeEdits(base.table, material.edits, control);
}

/// @param usual the grid where the options have none of this kind.
Encoded encodeTable(const EditedMaterial& material, const HalfDifferenceGrid& usual, const EncodeOptions& options,
                    const TaskControl& control) {
  const HalfDifferenceGrid grid = options.grid && options.grid->reciprocal == usual.reciprocal ? *options.grid : usual;
  if (const auto own = ownTable(material, grid.reciprocal, control)) return {io::encodeMerl(*own), own};
  const auto table = bakeTable(*material.shown.brdf, grid, control, editing::bakedAzimuths);
  Encoded made{io::encodeMerl(*table), table};
  made.losses.push_back("the values were sampled at " + gridText(grid) + " half-difference angles");
  if (table->clampedCount() > 0) made.losses.push_back(clippedText(table->clampedCount()));
  return made;
}

/// The values at the nodes of UTIA files. Those of a UTIA file change by the difference that the edits make there.
std::vector<glm::vec3> utiaValues(const EditedMaterial& material, const TaskControl& control) {
  const auto* file = dynamic_cast<const UtiaBrdf*>(material.base.brdf.get());
  const auto own = file ? file->withIncident(IncidentDirection::viewer) : nullptr;
  constexpr std::size_t side = UtiaBrdf::directionCount;
  std::vector<glm::vec3> values(side * side);
  std::vector<Rgb> before(side, Rgb(0)), after(side);
  for (std::size_t incident = 0; incident < side; ++incident) {
    control.throwIfStopped();
    const std::vector<DirectionPair> pairs = UtiaBrdf::nodes(incident);
    material.shown.brdf->evaluate(pairs, after);
    if (own) own->evaluate(pairs, before);
    for (std::size_t i = 0; i < side; ++i) {
      const std::size_t node = incident * side + i;
      const Rgb start = own ? Rgb((*file->values())[node]) : Rgb(0);
      values[node] = glm::vec3(before[i] == after[i] ? start : start + after[i] - before[i]);
    }
    control.report(double(incident) / side);
  }
  return values;
}

/// Of a table that folds phi_d that table, edited cell by cell; of other materials 90 x 90 x 180 angles.
Encoded encodeMerlMaterial(const EditedMaterial& material, const EncodeOptions& options, const TaskControl& control) {
  return encodeTable(material, {}, options, control);
}

/// The same for tables that cover the whole circle of phi_d, 90 x 90 x 360 angles.
Encoded encodeMerlCircleMaterial(const EditedMaterial& material, const EncodeOptions& options,
                                 const TaskControl& control) {
  return encodeTable(material, {.phiDCount = 360, .reciprocal = false}, options, control);
}

/// The spectral file if the material is a spectral RGL file whose spectra encodeRgl() keeps, else the RGB file.
Encoded encodeRglMaterial(const EditedMaterial& material, const EncodeOptions& options, const TaskControl& control) {
  rgl::EncodedRgl files = encodeRgl(material, options, control);
  const RglBrdf* source = material.base.brdf->asRgl();
  const bool spectral = source && source->tables()->data.spectra && files.ownParameterisation;
  Encoded made{spectral ? std::move(files.spectral) : std::move(files.rgb),
               spectral ? files.spectralBrdf : files.rgbBrdf, lossesOf(files)};
  made.snr = spectral ? files.spectralSnr : files.rgbSnr;
  return made;
}

/// A `.bin` file. Of a UTIA file, the change of the edits is added to the values at its nodes.
Encoded encodeUtiaMaterial(const EditedMaterial& material, const EncodeOptions&, const TaskControl& control) {
  std::vector<glm::vec3> values = utiaValues(material, control);
  Encoded made;
  std::size_t clipped = 0;
  for (glm::vec3& value : values) {
    clipped += std::size_t((value.x < 0) + (value.y < 0) + (value.z < 0));
    value = glm::max(value, glm::vec3(0));
  }
  made.bytes = io::encodeUtia(values);
  if (!dynamic_cast<const UtiaBrdf*>(material.base.brdf.get()))
    made.losses.push_back("the values were sampled at 288 x 288 directions, every 15 by 7.5 degrees");
  if (clipped > 0) made.losses.push_back(clippedText(clipped));
  made.readBack = std::make_shared<const UtiaBrdf>(std::move(values));
  return made;
}

constexpr std::string_view merlSuffixes[] = {".binary"}, bsdfSuffixes[] = {".bsdf"}, utiaSuffixes[] = {".bin", ".exr"},
                           astmSuffixes[] = {".astm"}, goniophotometerSuffixes[] = {".txt"}, curetSuffixes[] = {".dat"},
                           pdvSuffixes[] = {".pdv"}, codeSuffixes[] = {".code"}, neuralSuffixes[] = {".nbrdf"};

constexpr std::array formats{
    MaterialFormat{.id = FormatId::merl,
                   .name = "MERL",
                   .label = "MERL file",
                   .suffixes = merlSuffixes,
                   .isSuffixAmbiguous = false,
                   .isMeasurement = true,
                   .holds = {},
                   .sniff = sniffMerl<true>,
                   .read = readMerlMaterial,
                   .encode = encodeMerlMaterial},
    MaterialFormat{.id = FormatId::merlCircle,
                   .name = "360-degree MERL",
                   .label = "360-degree MERL file",
                   .suffixes = merlSuffixes,
                   .isSuffixAmbiguous = false,
                   .isMeasurement = true,
                   .holds = {.nonReciprocal = true},
                   .sniff = sniffMerl<false>,
                   .read = readMerlMaterial,
                   .encode = encodeMerlCircleMaterial},
    MaterialFormat{.id = FormatId::rgl,
                   .name = "RGL",
                   .label = "RGL file",
                   .suffixes = bsdfSuffixes,
                   .isSuffixAmbiguous = false,
                   .isMeasurement = true,
                   .holds = {.nonReciprocal = true, .anisotropic = true, .spectral = true},
                   .sniff = io::expectTensorFile,
                   .read = readRglMaterial,
                   .encode = encodeRglMaterial},
    MaterialFormat{.id = FormatId::utia,
                   .name = "UTIA",
                   .label = "UTIA file",
                   .suffixes = utiaSuffixes,
                   .isSuffixAmbiguous = true,
                   .isMeasurement = true,
                   .holds = {.nonReciprocal = true, .anisotropic = true},
                   .sniff = io::expectUtia,
                   .read = readUtiaMaterial,
                   .encode = encodeUtiaMaterial},
    MaterialFormat{.id = FormatId::zemax,
                   .name = "Zemax",
                   .label = "Zemax BSDF",
                   .suffixes = bsdfSuffixes,
                   .isSuffixAmbiguous = false,
                   .isMeasurement = true,
                   .holds = {.nonReciprocal = true},
                   .sniff = io::expectZemax,
                   .read = readIncidenceMaterial<io::readZemax>,
                   .encode = nullptr},
    MaterialFormat{.id = FormatId::lightTools,
                   .name = "LightTools",
                   .label = "LightTools BSDF",
                   .suffixes = bsdfSuffixes,
                   .isSuffixAmbiguous = false,
                   .isMeasurement = true,
                   .holds = {.nonReciprocal = true},
                   .sniff = io::expectLightTools,
                   .read = readIncidenceMaterial<io::readLightTools>,
                   .encode = nullptr},
    MaterialFormat{.id = FormatId::astm,
                   .name = "ASTM",
                   .label = "ASTM E1392 samples",
                   .suffixes = astmSuffixes,
                   .isSuffixAmbiguous = false,
                   .isMeasurement = false,
                   .holds = {},
                   .sniff = io::expectAstm,
                   .read = readScatteredMaterial<io::readAstm>,
                   .encode = nullptr},
    MaterialFormat{.id = FormatId::goniophotometer,
                   .name = "pgII",
                   .label = "pgII samples",
                   .suffixes = goniophotometerSuffixes,
                   .isSuffixAmbiguous = true,
                   .isMeasurement = false,
                   .holds = {},
                   .sniff = io::expectGoniophotometer,
                   .read = readScatteredMaterial<io::readGoniophotometer>,
                   .encode = nullptr},
    MaterialFormat{.id = FormatId::curet,
                   .name = "CUReT",
                   .label = "CUReT samples",
                   .suffixes = curetSuffixes,
                   .isSuffixAmbiguous = true,
                   .isMeasurement = false,
                   .holds = {},
                   .sniff = io::expectCuret,
                   .read = readScatteredMaterial<io::readCuret>,
                   .encode = nullptr},
    MaterialFormat{.id = FormatId::pdv,
                   .name = "PDV factors",
                   .label = "PDV factors",
                   .suffixes = pdvSuffixes,
                   .isSuffixAmbiguous = false,
                   .isMeasurement = false,
                   .holds = {.nonReciprocal = true},
                   .sniff = expectPdv,
                   .read = readPdvMaterial,
                   .encode = nullptr},
    MaterialFormat{.id = FormatId::code,
                   .name = "sparse code",
                   .label = "sparse code",
                   .suffixes = codeSuffixes,
                   .isSuffixAmbiguous = false,
                   .isMeasurement = false,
                   .holds = {.nonReciprocal = true},
                   .sniff = expectCode,
                   .read = readCodeMaterial,
                   .encode = nullptr},
    MaterialFormat{.id = FormatId::neural,
                   .name = "neural BRDF",
                   .label = "neural BRDF",
                   .suffixes = neuralSuffixes,
                   .isSuffixAmbiguous = false,
                   .isMeasurement = false,
                   .holds = {},
                   .sniff = expectNeural,
                   .read = readNeuralMaterial,
                   .encode = nullptr},
};

}  // namespace

std::span<const MaterialFormat> materialFormats() { return formats; }

const MaterialFormat& formatOf(FormatId id) { return *std::ranges::find(formats, id, &MaterialFormat::id); }

const MaterialFormat* formatBySuffix(const std::filesystem::path& path) {
  const std::string suffix = lowerCase(path.extension().string());
  for (const MaterialFormat& format : formats)
    if (!format.isSuffixAmbiguous && std::ranges::find(format.suffixes, suffix) != format.suffixes.end())
      return &format;
  return nullptr;
}

bool hasSuffixOf(FormatId id, const std::filesystem::path& path) { return formatBySuffix(path) == &formatOf(id); }

const MaterialFormat* formatOfFile(const std::filesystem::path& path) {
  try {
    return &sniffFormat(io::FileSource(path));
  } catch (const Error&) {
    return formatBySuffix(path);
  }
}

bool isMaterialFile(const std::filesystem::path& path) { return formatBySuffix(path) || formatOfFile(path); }

const MaterialFormat& sniffFormat(const io::ByteSource& source) {
  if (source.size() == 0) throw Error("the file is empty, expected a material");
  std::string refusals, verdict;
  for (const MaterialFormat& format : formats) {
    try {
      format.sniff(source);
      return format;
    } catch (const io::FormatMismatch& mismatch) {
      const std::string refusal = "\n  " + std::string(format.name) + ": " + mismatch.what();
      if (!refusals.ends_with(refusal)) refusals += refusal;
      if (!mismatch.verdict().empty() && verdict.empty())
        verdict = mismatch.verdict() + " (" + std::string(format.name) + ")";
    }
  }
  throw Error((verdict.empty() ? "this file could not be read: it matches no format that Gonio supports" : verdict) +
              refusals);
}

namespace {

/// ".binary, .bsdf or .pdv".
std::string listOf(const std::vector<std::string_view>& suffixes, std::string_view conjunction) {
  std::string text;
  for (std::size_t i = 0; i < suffixes.size(); ++i) {
    if (i > 0) text.append(i + 1 < suffixes.size() ? ", " : " " + std::string(conjunction) + " ");
    text.append(suffixes[i]);
  }
  return text;
}

void addOnce(std::vector<std::string_view>& suffixes, std::string_view suffix) {
  if (std::ranges::find(suffixes, suffix) == suffixes.end()) suffixes.push_back(suffix);
}

}  // namespace

std::string suffixText(bool (*isWanted)(const MaterialFormat& format), std::string_view conjunction) {
  std::vector<std::string_view> suffixes;
  for (const MaterialFormat& format : formats)
    if (isWanted(format))
      for (const std::string_view suffix : format.suffixes) addOnce(suffixes, suffix);
  return listOf(suffixes, conjunction);
}

std::string writableSuffixText(std::string_view other) {
  std::vector<std::string_view> suffixes;
  for (const MaterialFormat& format : formats)
    if (format.encode) addOnce(suffixes, format.suffix());
  if (!other.empty()) suffixes.push_back(other);
  return listOf(suffixes, "or");
}

}  // namespace gonio::materials
