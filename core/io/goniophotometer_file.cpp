// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/goniophotometer_file.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/io/format_mismatch.h"
#include "core/io/text_lines.h"
#include "core/math/spectrum.h"
#include "core/support/lower_case.h"

namespace gonio::io {

namespace {

const std::string expectedGoniophotometer =
    "# lines with 'format: theta phi BSDF' (or DSF) and 'intheta', 'inphi' or 'incident_angle'";

struct GoniophotometerHeader {
  std::string quantity;              ///< "dsf", "bsdf", "brdf", "btdf"
  std::string colorimetry, sample;   ///< may be empty
  std::optional<double> theta, phi;  ///< of the light, degrees
  std::optional<TextLine> incidentLine;
};

std::string lower(std::string_view text) { return lowerCase(std::string(text)); }

/// A # line: its words, the first in lower case without a colon.
void readHeaderLine(const TextLine& line, GoniophotometerHeader& header) {
  const std::vector<std::string_view> all = words(line.text.substr(1));
  if (all.empty()) return;
  std::string key = lower(all[0]);
  if (key.ends_with(':')) key.pop_back();
  const auto number = [&](std::size_t word) -> double {
    const auto value = word < all.size() ? finiteNumber(all[word]) : std::nullopt;
    if (!value)
      throw FormatMismatch("'" + key + "' without an angle in line " + std::to_string(line.number),
                           expectedGoniophotometer);
    return *value;
  };
  if (key == "format" && all.size() >= 4 && lower(all[1]) == "theta" && lower(all[2]) == "phi")
    header.quantity = lower(all[3]);
  if (key == "colorimetry" && all.size() > 1) header.colorimetry = lower(all[1]);
  if (key == "sample_name") {
    const auto begin = std::min(line.text.find('"'), line.text.size());
    header.sample = std::string(line.text.substr(begin));
    std::erase(header.sample, '"');
  }
  if (key == "intheta" || key == "incident_angle") {
    header.theta = number(1);
    header.incidentLine = line;
  }
  if (key == "inphi") header.phi = number(1);
  if (key == "incident_angle") header.phi = number(2);
}

/// Reads the # lines at the start. @return the first line of another kind, if there is one.
std::optional<TextLine> readGoniophotometerHeader(TextLines& lines, GoniophotometerHeader& header) {
  std::optional<TextLine> line = lines.next();
  if (!line || !line->text.starts_with('#'))
    throw FormatMismatch("a first line that does not begin with #", expectedGoniophotometer);
  for (; line && line->text.starts_with('#'); line = lines.next()) readHeaderLine(*line, header);
  if (header.quantity.empty() || !header.theta || !header.phi)
    throw FormatMismatch("# lines without the quantity or the incident direction", expectedGoniophotometer);
  return line;
}

/// Of the values after the two angles.
Rgb colourOf(const GoniophotometerHeader& header, const std::vector<double>& row) {
  if (row.size() == 3) return Rgb(row[2]);
  const glm::dvec3 three(row[2], row[3], row[4]);
  return header.colorimetry == "cie-xyz" ? linearSrgb(three) : three;
}

/// With the side of the light above.
Direction directionOf(double theta, double phi, bool fromBelow) {
  return fromSpherical(radians(fromBelow ? 180 - theta : theta), radians(phi));
}

}  // namespace

void expectGoniophotometer(const ByteSource& source) {
  const std::string head = textHead(source, expectedGoniophotometer);
  TextLines lines(head);
  GoniophotometerHeader header;
  readGoniophotometerHeader(lines, header);
}

ScatteredSamples readGoniophotometer(const ByteSource& source) {
  const std::string text = allText(source);
  TextLines lines(text);
  GoniophotometerHeader header;
  std::optional<TextLine> line = readGoniophotometerHeader(lines, header);
  const bool isTimesCosine = header.quantity == "dsf";
  if (!isTimesCosine && header.quantity != "bsdf" && header.quantity != "brdf")
    throw FormatMismatch("the quantity '" + header.quantity + "'", "reflection: BSDF, BRDF or DSF");
  const bool fromBelow = *header.theta > 90;
  const Direction light = directionOf(*header.theta, *header.phi, fromBelow);
  if (!(light.z > horizonTolerance))
    header.incidentLine->fail("an incident direction that is not at 90 degrees from the normal");
  ScatteredSamples samples;
  samples.description = header.sample;
  std::size_t columns = 0;
  for (; line; line = lines.next()) {
    if (line->text.starts_with('#')) continue;
    const std::vector<double> row = finiteNumbers(*line);
    if (columns == 0) columns = row.size();
    if (row.size() != columns || (columns != 3 && columns != 5))
      line->fail("theta, phi and one or three values, as many as in the first row");
    const Direction out = directionOf(row[0], row[1], fromBelow);
    const double divisor = isTimesCosine && out.z > horizonTolerance ? out.z : 1;
    const Rgb value = colourOf(header, row) / divisor;
    if (!std::isfinite(value.x + value.y + value.z)) line->fail("values that give a finite BRDF");
    samples.add({light, out}, value);
  }
  if (samples.values.empty()) throw Error("found no row of reflected light, expected theta, phi and values");
  return samples;
}

}  // namespace gonio::io
