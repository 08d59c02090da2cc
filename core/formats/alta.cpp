// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/coordinates/half_difference.h"
#include "core/formats/formats.h"
#include "core/formats/scattered_samples.h"
#include "core/io/byte_source.h"
#include "core/io/text_lines.h"
#include "core/math/colour.h"

/// Text data of ALTA (Belcour, Barla and Pacanowski 2016, "ALTA: A BRDF Analysis Library"), `.alta`: a header of lines
/// that begin with #, then a row for each point, its coordinates and values.
///
///     #ALTA_BEGIN_HEADER
///     #DIM 3 3
///     #PARAM_IN ISOTROPIC_TV_TL_DPHI
///     #PARAM_OUT RGB_COLOR
///     #VS 0
///     #ALTA_END_HEADER
///     0 0.3 1.5 0.31 0.30 0.28
///
/// Angles in radians. Coordinates that are read: ISOTROPIC_TV_TL_DPHI (polar angles of viewer and light, azimuth
/// of the light less that of the viewer), SPHERICAL_TL_PL_TV_PV (polar angle and azimuth of light, then viewer),
/// CARTESIAN (unit vectors to viewer, then light), RUSIN_TH_TD_PD and RUSIN_TH_PH_TD_PD (half and difference angles;
/// ALTA derives the viewer from the difference vector). Values: RGB_COLOR (linear sRGB), XYZ_COLOR (D65 white at Y =
/// 1), INV_STERADIAN (one, grey, or three, RGB), INV_STERADIAN_COSINE_FACTOR (the same times the cosine of the viewer,
/// by which they are divided). With #VS 1 or 2, rows end with confidence intervals, which are not used. Binary data
/// (#FORMAT binary) is rejected.
namespace gonio::formats {

namespace {

const std::string expectedAlta = "a first line '#ALTA_BEGIN_HEADER' or '#ALTA HEADER BEGIN' (ALTA)";

enum class AltaInput { isotropic, spherical, cartesian, isotropicHalf, half };
enum class AltaOutput { rgb, xyz, brdf, brdfCosine };

template <typename Value>
struct AltaName {
  std::string_view name;
  std::size_t dimension;  ///< 0: one or three
  Value value;
};
constexpr std::array altaInputs{AltaName<AltaInput>{"ISOTROPIC_TV_TL_DPHI", 3, AltaInput::isotropic},
                                AltaName<AltaInput>{"SPHERICAL_TL_PL_TV_PV", 4, AltaInput::spherical},
                                AltaName<AltaInput>{"CARTESIAN", 6, AltaInput::cartesian},
                                AltaName<AltaInput>{"RUSIN_TH_TD_PD", 3, AltaInput::isotropicHalf},
                                AltaName<AltaInput>{"RUSIN_TH_PH_TD_PD", 4, AltaInput::half}};
constexpr std::array altaOutputs{AltaName<AltaOutput>{"RGB_COLOR", 3, AltaOutput::rgb},
                                 AltaName<AltaOutput>{"XYZ_COLOR", 3, AltaOutput::xyz},
                                 AltaName<AltaOutput>{"INV_STERADIAN", 0, AltaOutput::brdf},
                                 AltaName<AltaOutput>{"INV_STERADIAN_COSINE_FACTOR", 0, AltaOutput::brdfCosine}};

struct AltaHeader {
  std::size_t inputs = 0, outputs = 0;  ///< of DIM
  std::string_view input, output;       ///< names
  bool hasIntervals = false;
};

/// The value of one of the names. @throws Error that lists them, or if the dimension is another one.
template <typename Names>
auto altaValue(const Names& names, std::string_view key, std::string_view name, std::size_t dimension) {
  const auto found = std::ranges::find(names, name, [](const auto& row) { return row.name; });
  if (found == names.end()) {
    std::string list;
    for (const auto& row : names) list += (list.empty() ? "" : ", ") + std::string(row.name);
    throw Error("found the " + std::string(key) + " '" + std::string(name) + "', expected one of " + list);
  }
  const bool fits = found->dimension == 0 ? dimension == 1 || dimension == 3 : dimension == found->dimension;
  if (!fits)
    throw Error("found " + std::to_string(dimension) + " numbers for " + std::string(name) + ", expected " +
                (found->dimension == 0 ? "1 or 3" : std::to_string(found->dimension)));
  return found->value;
}

/// A number of DIM.
std::size_t altaCount(const io::TextLine& line, std::string_view word) {
  std::size_t count = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
  constexpr std::size_t most = 100;
  if (error != std::errc() || end != word.data() + word.size() || count < 1 || count > most)
    line.fail("#DIM and the numbers of coordinates and values");
  return count;
}

void readAltaKey(const io::TextLine& line, AltaHeader& header) {
  const std::vector<std::string_view> words = io::words(line.text.substr(1));
  if (words.empty()) return;
  if (words[0] == "DIM") {
    if (words.size() < 3) line.fail("#DIM and the numbers of coordinates and values");
    header.inputs = altaCount(line, words[1]);
    header.outputs = altaCount(line, words[2]);
  }
  if (words[0] == "PARAM_IN" && words.size() > 1) header.input = words[1];
  if (words[0] == "PARAM_OUT" && words.size() > 1) header.output = words[1];
  if (words[0] == "VS")
    header.hasIntervals = std::ranges::any_of(words.begin() + 1, words.end(), [](auto word) { return word != "0"; });
  if (words[0] == "FORMAT" && words.size() > 1 && words[1] != "text")
    throw Error("found data in the format '" + std::string(words[1]) +
                "', expected text: binary ALTA files are not read");
}

/// Viewer and light at the azimuth of a half vector.
DirectionPair ofHalf(double thetaH, double phiH, double thetaD, double phiD) {
  const auto [viewer, light] = fromHalfDifference(thetaH, thetaD, phiD);
  const AzimuthRotation turn(phiH);
  return {turn(light), turn(viewer)};
}

DirectionPair altaDirections(AltaInput input, const std::vector<double>& at, const io::TextLine& line) {
  const auto vector = [&](std::size_t first) {
    const Direction w(at[first], at[first + 1], at[first + 2]);
    constexpr double tolerance = 1e-3;  // of numbers with few digits
    if (!(std::abs(glm::length(w) - 1) < tolerance)) line.fail("unit vectors to viewer and light");
    return glm::normalize(w);
  };
  switch (input) {
    case AltaInput::isotropic:
      return {fromSpherical(at[1], 0), fromSpherical(at[0], -at[2])};
    case AltaInput::spherical:
      return {fromSpherical(at[0], at[1]), fromSpherical(at[2], at[3])};
    case AltaInput::cartesian:
      return {vector(3), vector(0)};
    case AltaInput::isotropicHalf:
      return ofHalf(at[0], 0, at[1], at[2]);
    case AltaInput::half:
      break;
  }
  return ofHalf(at[0], at[1], at[2], at[3]);
}

Rgb altaColour(AltaOutput output, const std::vector<double>& row, const AltaHeader& header) {
  const double* values = row.data() + header.inputs;
  if (header.outputs == 1) return Rgb(values[0]);
  const glm::dvec3 three(values[0], values[1], values[2]);
  return output == AltaOutput::xyz ? linearSrgb(three) : three;
}

void sniffAlta(const io::ByteSource& source) {
  // Binary data follows the header of a binary file.
  std::string head(std::size_t(std::min<std::uint64_t>(source.size(), 16)), '\0');
  source.readAt(0, std::as_writable_bytes(std::span(head)));
  const std::string_view start = io::withoutByteOrderMark(head);
  if (!start.starts_with("#ALTA_BEGIN") && !start.starts_with("#ALTA HEADER"))
    throw io::FormatMismatch("another start", expectedAlta);
}

constexpr std::string_view altaSuffixes[] = {".alta"};

}  // namespace

ScatteredSamples readAlta(const io::ByteSource& source) {
  const std::string text = io::allText(source);
  AltaHeader header;
  io::TextLines lines(text);
  auto line = lines.next();
  for (; line && line->text.starts_with('#'); line = lines.next()) readAltaKey(*line, header);
  if (header.inputs == 0 || header.input.empty() || header.output.empty())
    throw Error("found a header without DIM, PARAM_IN or PARAM_OUT, expected these keys");
  const AltaInput input = altaValue(altaInputs, "PARAM_IN", header.input, header.inputs);
  const AltaOutput output = altaValue(altaOutputs, "PARAM_OUT", header.output, header.outputs);
  const io::NumberNotation notation = io::notationOf(text).unambiguous();
  const std::size_t numbers = header.inputs + header.outputs;
  ScatteredSamples samples;
  for (; line; line = lines.next()) {
    const std::vector<double> row = io::finiteNumbers(*line, notation);
    if (row.empty()) continue;
    if (row.size() < numbers || (row.size() > numbers && !header.hasIntervals))
      line->fail(std::to_string(header.inputs) + " coordinates and " + std::to_string(header.outputs) + " values");
    const DirectionPair pair = altaDirections(input, row, *line);
    const bool isTimesCosine = output == AltaOutput::brdfCosine && pair.wo.z > horizonTolerance;
    const Rgb value = altaColour(output, row, header) / (isTimesCosine ? pair.wo.z : 1);
    if (!std::isfinite(value.x + value.y + value.z)) line->fail("values that give a finite BRDF");
    samples.add(pair, value);
  }
  if (samples.values.empty()) throw Error("found no point above the horizon, expected rows after the header");
  samples.notes.push_back("read as: " + std::string(header.input) + " in radians; " + std::string(header.output) +
                          (header.outputs == 1 ? " as grey" : "") +
                          (output == AltaOutput::brdfCosine ? ", divided by cos theta_v" : "") + "; " +
                          notation.text());
  if (header.hasIntervals) samples.notes.push_back("confidence intervals of the file are not used");
  return samples;
}

constinit const MaterialFormat altaFormat{.name = "ALTA",
                                          .label = "ALTA data",
                                          .suffixes = altaSuffixes,
                                          .holds = {.nonReciprocal = true, .anisotropic = true},
                                          .sniff = sniffAlta,
                                          .read = readPoints<readAlta>};

}  // namespace gonio::formats
