// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/formats/formats.h"
#include "core/formats/scattered_samples.h"
#include "core/io/byte_source.h"
#include "core/io/json_text.h"
#include "core/io/text_lines.h"
#include "core/math/colour.h"
#include "core/support/json_object.h"
#include "core/support/text.h"

/// BRDF tables of ASAM OpenMATERIAL 3D 1.0, `.xompt`: JSON with `metadata` and `brdf`, whose `lookupTable` has rows of
/// wavelength (m), polar angles of incidence and exit, azimuth of the exit relative to the incident one (rad), and the
/// BRDF in 1/sr:
///
///     {"metadata": {"name": "asphalt"},
///      "brdf": {"wavelengths": [5.5e-7], "lookupTable": [[5.5e-7, 0.3, 0.2, 3.14, 0.05]]}}
///
/// Every direction has a value for every wavelength of the table. Three or more wavelengths, some of them visible,
/// become a colour by spectrumWeights(); the mean of others is grey. Azimuth 0 is the side of the light: the standard
/// says that the incident ray is the reference, not whether it is the direction to the light. Rows that contain null
/// are left out. The other tables of the standard (reflection coefficients, electromagnetic properties) are no BRDF.
namespace gonio::formats {

namespace {

const std::string expectedOpenMaterial = "JSON with the member 'lookupTable' of 'brdf' (OpenMATERIAL)";

/// Values of a direction, by wavelength in nm.
using Spectrum = std::map<double, double>;
/// Polar angles of incidence and exit, azimuth.
using TableAngles = std::array<double, 3>;

constexpr double visibleBegin = 380, visibleEnd = 780;  ///< nm

/// The rows of a table by directions.
std::map<TableAngles, Spectrum> spectraOf(const nlohmann::json& table, std::size_t& nulls) {
  std::map<TableAngles, Spectrum> result;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const nlohmann::json& row = table[i];
    const auto fail = [&](const std::string& found, const std::string& expected) {
      throw Error("brdf.lookupTable[" + std::to_string(i) + "]: found " + found + ", expected " + expected);
    };
    constexpr std::size_t columns = 5;
    if (!row.is_array() || row.size() != columns)
      fail(describeJson(row), "wavelength, incident and exit polar angle, azimuth and BRDF");
    if (std::ranges::any_of(row, [](const nlohmann::json& number) { return number.is_null(); })) {
      ++nulls;
      continue;
    }
    std::array<double, columns> numbers{};
    for (std::size_t column = 0; column < columns; ++column) {
      if (!row[column].is_number() || !std::isfinite(row[column].get<double>()))
        fail(describeJson(row[column]), "a finite number");
      numbers[column] = row[column].get<double>();
    }
    const auto& [wavelength, thetaI, thetaO, phi, value] = numbers;
    constexpr double rounding = 1e-4;  // of angles with few digits
    if (!(wavelength > 0 && wavelength < 1)) fail("the wavelength " + numberText(wavelength), "metres");
    for (const double theta : {thetaI, thetaO})
      if (!(theta >= 0 && theta <= halfPi + rounding))
        fail("the polar angle " + numberText(theta), "radians from 0 to pi/2");
    constexpr double nanometres = 1e9;
    if (!result[{thetaI, thetaO, phi}].emplace(wavelength * nanometres, value).second)
      fail("a second value for these directions and wavelength", "one");
  }
  return result;
}

/// Weights of the wavelengths, ascending; and what they are for the note.
std::pair<std::vector<Rgb>, std::string> weightsOf(const std::vector<double>& wavelengths) {
  const std::string range =
      numberText(std::round(wavelengths.front())) + " to " + numberText(std::round(wavelengths.back())) + " nm";
  const bool isVisible = std::ranges::any_of(
      wavelengths, [](double wavelength) { return wavelength >= visibleBegin && wavelength <= visibleEnd; });
  if (isVisible && wavelengths.size() >= 3)
    return {spectrumWeights(wavelengths), std::to_string(wavelengths.size()) + " wavelengths, " + range};
  return {std::vector<Rgb>(wavelengths.size(), Rgb(1 / double(wavelengths.size()))),
          "the mean of " + std::to_string(wavelengths.size()) + " wavelengths, " + range + ", as grey"};
}

void sniffOpenMaterial(const io::ByteSource& source) {
  const std::string head = io::textHead(source, expectedOpenMaterial);
  const std::string_view start = io::withoutByteOrderMark(head);
  if (start.substr(std::min(start.find_first_not_of(" \t\r\n"), start.size())).starts_with('{') &&
      head.find("\"brdf\"") != std::string::npos && head.find("\"lookupTable\"") != std::string::npos)
    return;
  throw io::FormatMismatch("a file of another format", expectedOpenMaterial);
}

constexpr std::string_view openMaterialSuffixes[] = {".xompt"};

}  // namespace

ScatteredSamples readOpenMaterial(const io::ByteSource& source) {
  const nlohmann::json document = io::parseJson(io::allText(source));
  const JsonObject root(document, "");
  std::size_t nulls = 0;
  const std::map<TableAngles, Spectrum> spectra = spectraOf(root.object("brdf").array("lookupTable"), nulls);
  if (spectra.empty()) throw Error("brdf.lookupTable: found no row with a value, expected at least one");
  std::vector<double> wavelengths;
  for (const auto& [wavelength, value] : spectra.begin()->second) wavelengths.push_back(wavelength);
  const auto [weights, text] = weightsOf(wavelengths);
  ScatteredSamples samples;
  for (const auto& [angles, spectrum] : spectra) {
    const auto& [thetaI, thetaO, phi] = angles;
    if (!std::ranges::equal(spectrum, wavelengths, {}, [](const auto& at) { return at.first; }))
      throw Error("brdf.lookupTable: found " + std::to_string(spectrum.size()) + " wavelengths at the polar angles " +
                  numberText(thetaI) + " and " + numberText(thetaO) + ", expected the " +
                  std::to_string(wavelengths.size()) + " of the first directions");
    Rgb value(0);
    std::size_t i = 0;
    for (const auto& [wavelength, at] : spectrum) value += at * weights[i++];
    if (!std::isfinite(value.x + value.y + value.z))
      throw Error("brdf.lookupTable: found values at the polar angles " + numberText(thetaI) + " and " +
                  numberText(thetaO) + " that are too large, expected BRDF values");
    samples.add({fromSpherical(thetaI, 0), fromSpherical(thetaO, phi)}, value);
  }
  samples.notes.push_back("read as: angles in radians; BRDF in 1/sr, " + text + "; azimuth 0 is the side of the light");
  if (nulls > 0) samples.notes.push_back(std::to_string(nulls) + " rows with null were left out");
  if (root.contains("metadata") && root.object("metadata").contains("name"))
    samples.description = root.object("metadata").text("name");
  return samples;
}

constinit const MaterialFormat openMaterialFormat{.name = "OpenMATERIAL",
                                                  .label = "OpenMATERIAL BRDF table",
                                                  .suffixes = openMaterialSuffixes,
                                                  .holds = {.nonReciprocal = true},
                                                  .sniff = sniffOpenMaterial,
                                                  .read = readPoints<readOpenMaterial>};

}  // namespace gonio::formats
