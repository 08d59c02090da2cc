// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>
#include <map>

#include "core/formats/formats.h"
#include "core/formats/scattered_samples.h"
#include "core/io/byte_source.h"
#include "core/io/text_lines.h"
#include "core/support/text.h"

/// Text that goniophotometers of STIL and Light Tec (REFLET, RT-300S) write for LightTools: one or more measurements,
/// each of lines with a key and its value between tabs, and then a line with the angle of incidence and rows of a polar
/// angle and values, one for each azimuth:
///
///     Data file type :        Intensity BRDF
///     Theta sample :          0
///     Phi measure beginning : -90
///     Phi measure end :       -80
///     Phi measure step :      10
///     Theta Lighting          60
///     -30                     0.02    0.03
///     0                       0.05    0.04
///
/// Degrees. A detector at polar angle 60 and azimuth -90 sees the mirror direction of a light at 60; a negative polar
/// angle lies on the other side of the normal. This follows from the converters of ansys/optical-automation and
/// ua-loft/bsdf-tools, as there is no public specification. Values of the type "Intensity BRDF" include the cosine of
/// the polar angle, as the former assumes, and are divided by it; values of other types of BRDF do not. They are read
/// as grey. Measurements at the same directions are averaged.
namespace gonio::formats {

namespace {

const std::string expectedReflet = "lines 'Data file type' and 'Theta Lighting' (REFLET)";

/// The lines of one measurement before its rows.
struct RefletHeader {
  std::string type;
  double sample = 0, phiBegin = 0, phiEnd = 0, phiStep = 0;  ///< degrees
  double light = 0;                                          ///< polar angle, degrees
};

/// The key of a line in lower case, without its colon; and its value.
std::pair<std::string, std::string> refletKey(std::string_view line) {
  std::size_t end = line.find_first_of(":\t");
  if (end == std::string_view::npos) end = line.size();
  const std::size_t last = line.substr(0, end).find_last_not_of(" \t");
  const std::size_t begin = std::min(line.find_first_not_of(" \t:", end), line.size());
  return {last == std::string_view::npos ? "" : lowerCase(std::string(line.substr(0, last + 1))),
          std::string(line.substr(begin))};
}

double refletNumber(const io::TextLine& line, const std::string& text, const io::NumberNotation& notation) {
  const auto value = io::finiteNumber(text, notation);
  if (!value) line.fail("a number after the key");
  return *value;
}

/// Reads a key. @return whether rows follow.
bool readRefletKey(const io::TextLine& line, const io::NumberNotation& notation, RefletHeader& header,
                   std::string& name) {
  const auto [key, value] = refletKey(line.text);
  if (key == "name / comment" && name.empty()) name = value;
  if (key == "data file type") header.type = lowerCase(value);
  const std::map<std::string_view, double*> numbers{{"theta sample", &header.sample},
                                                    {"phi measure beginning", &header.phiBegin},
                                                    {"phi measure end", &header.phiEnd},
                                                    {"phi measure step", &header.phiStep},
                                                    {"theta lighting", &header.light}};
  const auto found = numbers.find(key);
  if (found != numbers.end()) *found->second = refletNumber(line, value, notation);
  return key == "theta lighting";
}

/// @throws io::FormatMismatch for transmission; Error for a tilted sample, a light below the horizon or azimuths
/// without a number of steps.
std::size_t refletAzimuths(const io::TextLine& line, const RefletHeader& header) {
  if (header.type.find("brdf") == std::string::npos)
    throw io::FormatMismatch("the data file type '" + header.type + "'", "reflection: BRDF");
  if (header.sample != 0) line.fail("a sample that is not tilted (Theta sample 0)");
  if (!(std::abs(header.light) < 90)) line.fail("an angle of incidence below 90 degrees");
  const double steps = header.phiStep == 0 ? 0 : (header.phiEnd - header.phiBegin) / header.phiStep;
  constexpr double most = 1e6;
  if (!(steps >= 0 && steps <= most) || std::abs(steps - std::round(steps)) > 1e-6)
    line.fail("azimuths from 'Phi measure beginning' to 'Phi measure end' in whole steps");
  return std::size_t(std::lround(steps)) + 1;
}

bool isRefletRow(const io::TextLine& line, const io::NumberNotation& notation) {
  const auto words = io::words(line.text, notation);
  return !words.empty() && io::finiteNumber(words[0], notation);
}

/// A row of values: those of a polar angle.
void addRefletRow(const io::TextLine& line, const io::NumberNotation& notation, const RefletHeader& header,
                  std::size_t azimuths, ScatteredSamples& samples) {
  const std::vector<double> row = io::finiteNumbers(line, notation);
  if (row.size() != azimuths + 1)
    line.fail("a polar angle and " + std::to_string(azimuths) + " values, one for each azimuth");
  // The light is at azimuth 0, its mirror direction at 180 degrees, which the instrument calls -90.
  constexpr double mirror = 180 + 90;
  const Direction wi = fromSpherical(radians(std::abs(header.light)), header.light < 0 ? pi : 0);
  for (std::size_t i = 0; i < azimuths; ++i) {
    const double phi = header.phiBegin + header.phiStep * double(i) + mirror + (row[0] < 0 ? 180 : 0);
    const Direction wo = fromSpherical(radians(std::abs(row[0])), radians(phi));
    const bool isIntensity = header.type.find("intensity") != std::string::npos;
    const double value = isIntensity && wo.z > horizonTolerance ? row[i + 1] / wo.z : row[i + 1];
    if (!std::isfinite(value)) line.fail("values that give a finite BRDF");
    samples.add({wi, wo}, Rgb(value));
  }
}

void sniffReflet(const io::ByteSource& source) {
  const std::string head = io::textHead(source, expectedReflet);
  bool hasType = false, hasLight = false;
  io::TextLines lines(head);
  while (const auto line = lines.next()) {
    const std::string key = refletKey(line->text).first;
    hasType = hasType || key == "data file type";
    hasLight = hasLight || key == "theta lighting";
  }
  if (!hasType || !hasLight) throw io::FormatMismatch("a text file of another format", expectedReflet);
}

constexpr std::string_view refletSuffixes[] = {".txt"};

}  // namespace

ScatteredSamples readReflet(const io::ByteSource& source) {
  const std::string text = io::allText(source);
  const io::NumberNotation notation = io::notationOf(text).unambiguous();
  ScatteredSamples samples;
  io::TextLines lines(text);
  RefletHeader header;
  std::size_t azimuths = 0, measurements = 0;  // of the measurement; 0: its rows have not begun
  bool hasIntensity = false;
  while (const auto line = lines.next()) {
    if (azimuths > 0 && isRefletRow(*line, notation)) {
      addRefletRow(*line, notation, header, azimuths, samples);
      continue;
    }
    if (azimuths > 0) header = {};
    azimuths = 0;
    if (!readRefletKey(*line, notation, header, samples.description)) continue;
    azimuths = refletAzimuths(*line, header);
    hasIntensity = hasIntensity || header.type.find("intensity") != std::string::npos;
    ++measurements;
  }
  if (samples.values.empty()) throw Error("found no row of reflected light, expected polar angles and values");
  samples.notes.push_back("read as: angles in degrees; " + std::to_string(measurements) +
                          " measurements of BRDF as grey" + (hasIntensity ? ", intensity divided by cos theta" : "") +
                          "; " + notation.text());
  if (std::ranges::all_of(samples.values, [](const Rgb& value) { return value == Rgb(0); }))
    samples.notes.push_back("warning: no value of the file is above 0");
  return samples;
}

constinit const MaterialFormat refletFormat{.name = "REFLET",
                                            .label = "REFLET samples",
                                            .suffixes = refletSuffixes,
                                            .isSuffixAmbiguous = true,
                                            .holds = {.nonReciprocal = true},
                                            .sniff = sniffReflet,
                                            .read = readPoints<readReflet>};

}  // namespace gonio::formats
