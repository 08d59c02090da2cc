// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/formats/formats.h"
#include "core/formats/scattered_samples.h"
#include "core/io/byte_source.h"
#include "core/io/text_lines.h"
#include "core/math/colour.h"
#include "core/support/text.h"

/// Text files of the pgII goniophotometer of pab (Apian-Bennewitz 2010, "New scanning gonio-photometer for extended
/// BRTF measurements"), also written by mgpp and read by Tekari: a header of lines that begin with #, then rows of
/// theta, phi (degrees) and values; one incident direction per file.
///
///     #sample_name "felt"
///     #format: theta phi BSDF
///     #intheta 30
///     #inphi 180
///     10.5 0 0.31
///
/// Keys that are read: `intheta` and `inphi`, or `incident_angle` with both; `format:` with the quantity, BSDF or BRDF
/// in 1/sr, or DSF, the BSDF times the cosine of the row's theta (the reader divides it by this cosine); `colorimetry:`
/// (for three values per row: CIE-XYZ, or RGB or nothing for linear sRGB; one value is grey); `sample_name`. Keys may
/// have a colon. Numbers may have decimal commas (io::notationOf()). Directions point away from the surface; theta is
/// the polar angle from its normal. A theta above 90 degrees is on the other side: rows on the side opposite to the
/// light are transmission and are ignored.
namespace gonio::formats {

namespace {

const std::string expectedGoniophotometer =
    "# lines with 'format: theta phi BSDF' (or DSF) and 'intheta', 'inphi' or 'incident_angle'";

struct GoniophotometerHeader {
  std::string quantity;              ///< "dsf", "bsdf", "brdf", "btdf"
  std::string colorimetry, sample;   ///< may be empty
  std::optional<double> theta, phi;  ///< of the light, degrees
  std::optional<io::TextLine> incidentLine;
};

std::string lower(std::string_view text) { return lowerCase(std::string(text)); }

/// The numbers after a key: separated by blanks, with either decimal sign; commas may separate two numbers where there
/// are no blanks between them, or before the blanks. Empty if there are not `count` numbers.
std::vector<double> numbersAfterKey(std::string_view line, std::size_t count) {
  for (const bool hasDecimalCommas : {true, false}) {
    const io::NumberNotation notation{.hasDecimalCommas = hasDecimalCommas};
    const auto all = io::words(line, notation);
    std::vector<double> numbers;
    for (std::size_t i = 1; i <= count && i < all.size(); ++i) {
      std::string_view word = all[i];
      if (word.ends_with(',')) word.remove_suffix(1);
      if (const auto value = io::finiteNumber(word, notation)) numbers.push_back(*value);
    }
    if (numbers.size() == count) return numbers;
  }
  return {};
}

/// A # line: its words, the first in lower case without a colon.
void readHeaderLine(const io::TextLine& line, GoniophotometerHeader& header) {
  const std::vector<std::string_view> all = io::words(line.text.substr(1));
  if (all.empty()) return;
  std::string key = lower(all[0]);
  if (key.ends_with(':')) key.pop_back();
  const auto numbers = [&](std::size_t count) {
    std::vector<double> result = numbersAfterKey(line.text.substr(line.text.find_first_not_of(" \t", 1)), count);
    if (result.empty())
      throw io::FormatMismatch("'" + key + "' without " + (count == 1 ? "an angle" : "two angles") + " in line " +
                                   std::to_string(line.number),
                               expectedGoniophotometer);
    return result;
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
    header.theta = numbers(key == "intheta" ? 1 : 2)[0];
    header.incidentLine = line;
  }
  if (key == "inphi") header.phi = numbers(1)[0];
  if (key == "incident_angle") header.phi = numbers(2)[1];
}

/// Reads the # lines at the start. @return the first line of another kind, if there is one.
std::optional<io::TextLine> readGoniophotometerHeader(io::TextLines& lines, GoniophotometerHeader& header) {
  std::optional<io::TextLine> line = lines.next();
  if (!line || !line->text.starts_with('#'))
    throw io::FormatMismatch("a first line that does not begin with #", expectedGoniophotometer);
  for (; line && line->text.starts_with('#'); line = lines.next()) readHeaderLine(*line, header);
  if (header.quantity.empty() || !header.theta || !header.phi)
    throw io::FormatMismatch("# lines without the quantity or the incident direction", expectedGoniophotometer);
  return line;
}

/// @throws Error if rows have three values in a colour space that is not known.
void checkColorimetry(const GoniophotometerHeader& header, std::size_t columns) {
  if (columns == 5 && !header.colorimetry.empty() && header.colorimetry != "cie-xyz" && header.colorimetry != "rgb" &&
      header.colorimetry != "srgb")
    throw Error("found colorimetry '" + header.colorimetry + "' for three values, expected CIE-XYZ or RGB");
}

/// The colour of a row: of the values after the two angles.
Rgb colourOf(const GoniophotometerHeader& header, const std::vector<double>& row) {
  if (row.size() == 3) return Rgb(row[2]);
  const glm::dvec3 three(row[2], row[3], row[4]);
  return header.colorimetry == "cie-xyz" ? linearSrgb(three) : three;
}

/// With the side of the light above.
Direction directionOf(double theta, double phi, bool fromBelow) {
  return fromSpherical(radians(fromBelow ? 180 - theta : theta), radians(phi));
}

void sniffGoniophotometer(const io::ByteSource& source) {
  const std::string head = io::textHead(source, expectedGoniophotometer);
  io::TextLines lines(head);
  GoniophotometerHeader header;
  readGoniophotometerHeader(lines, header);
}

constexpr std::string_view goniophotometerSuffixes[] = {".txt"};

}  // namespace

ScatteredSamples readGoniophotometer(const io::ByteSource& source) {
  const std::string text = io::allText(source);
  io::TextLines lines(text);
  GoniophotometerHeader header;
  std::optional<io::TextLine> line = readGoniophotometerHeader(lines, header);
  const bool isTimesCosine = header.quantity == "dsf";
  if (!isTimesCosine && header.quantity != "bsdf" && header.quantity != "brdf")
    throw io::FormatMismatch("the quantity '" + header.quantity + "'", "reflection: BSDF, BRDF or DSF");
  const bool fromBelow = *header.theta > 90;
  const Direction light = directionOf(*header.theta, *header.phi, fromBelow);
  if (!(light.z > horizonTolerance))
    header.incidentLine->fail("an incident direction that is not at 90 degrees from the normal");
  ScatteredSamples samples;
  samples.description = header.sample;
  const io::NumberNotation notation = io::notationOf(text).unambiguous();
  std::size_t columns = 0;
  for (; line; line = lines.next()) {
    if (line->text.starts_with('#')) continue;
    const std::vector<double> row = io::finiteNumbers(*line, notation);
    if (columns == 0) columns = row.size();
    if (row.size() != columns || (columns != 3 && columns != 5))
      line->fail("theta, phi and one or three values, as many as in the first row (" + notation.text() + ")");
    checkColorimetry(header, columns);
    const Direction out = directionOf(row[0], row[1], fromBelow);
    const double divisor = isTimesCosine && out.z > horizonTolerance ? out.z : 1;
    const Rgb value = colourOf(header, row) / divisor;
    if (!std::isfinite(value.x + value.y + value.z)) line->fail("values that give a finite BRDF");
    samples.add({light, out}, value);
  }
  samples.notes.push_back("read as: theta, phi in degrees; " + header.quantity + " " +
                          (columns == 3                      ? "as grey"
                           : header.colorimetry == "cie-xyz" ? "as X, Y, Z"
                                                             : "as R, G, B (linear sRGB)") +
                          (isTimesCosine ? ", divided by cos theta" : "") + "; " + notation.text());
  if (samples.values.empty()) throw Error("found no row of reflected light, expected theta, phi and values");
  return samples;
}

constinit const MaterialFormat goniophotometerFormat{.name = "pgII",
                                                     .label = "pgII samples",
                                                     .suffixes = goniophotometerSuffixes,
                                                     .isSuffixAmbiguous = true,
                                                     .sniff = sniffGoniophotometer,
                                                     .read = readScattered<readGoniophotometer>};

}  // namespace gonio::formats
