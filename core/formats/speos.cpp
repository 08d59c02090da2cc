// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>

#include "core/formats/formats.h"
#include "core/formats/scatter_table.h"
#include "core/formats/scattered_samples.h"
#include "core/io/byte_source.h"
#include "core/math/colour.h"

/// Text files of anisotropic surfaces of Ansys Speos (OPTIS), `.anisotropicbsdf`, versions 7 and 8:
///
///     OPTIS - Anisotropic BSDF surface file v8.0
///     0                           text, not binary
///     Comment
///     23                          characters of the next line
///     Measurement description
///     0 1 0                       axis of the anisotropy
///     1 0                         whether there is reflection, transmission
///     1                           values: 1 BSDF, 0 intensity (with the cosine)
///     1                           sample rotations,
///     0
///     2                           angles of incidence of each
///     15 30
///     15 0                        the incidence of the spectrum
///     2                           wavelengths and percent of reflected light
///     350 13.4
///     850 13.4
///     3 2                         a block for each rotation and incidence: polar angles and azimuths
///         0   180                 azimuths
///     0   0.2 0.2                 polar angle and values
///     ..
///     End of file
///
/// Degrees. Polar angles are about the normal; azimuth 0 is on the side of the mirror direction. Values are relative:
/// one factor scales all blocks so that the block of the spectrum reflects its percentage. There is no public
/// specification; this follows from the converter of ansys/optical-automation and agrees with its pair of files of one
/// material in both formats (Zemax and Speos). Rotations are those of Zemax files. A spectrum that is not constant
/// colours all directions alike.
namespace gonio::formats {

namespace {

constexpr std::string_view speosStart = "OPTIS - Anisotropic BSDF surface file";
const std::string expectedSpeos = "a first line '" + std::string(speosStart) + "' (Ansys Speos)";

/// Lines 3 to 5 are free text.
constexpr int firstFreeLine = 3, lastFreeLine = 5;

/// The text with spaces in its first line and its free ones: every other word is a number, in its line.
std::string withoutFreeText(std::string text) {
  int line = 1;
  for (char& c : text) {
    if (c == '\n')
      ++line;
    else if (line == 1 || (line >= firstFreeLine && line <= lastFreeLine))
      c = ' ';
    if (line > lastFreeLine) break;
  }
  return text;
}

struct SpeosBlock {
  double rotation = 0, incident = 0;     ///< degrees
  std::vector<double> azimuths, polars;  ///< degrees
  std::vector<double> values;            ///< [polar][azimuth]

  double at(std::size_t polar, std::size_t azimuth) const { return values[polar * azimuths.size() + azimuth]; }
};

struct SpeosFile {
  bool isIntensity = false;
  double spectrumTheta = 0;  ///< degrees
  Rgb reflected{0};          ///< of the incidence of the spectrum, 0 to 1
  std::vector<SpeosBlock> blocks;
};

bool flagOf(WordReader& words, const char* what) {
  const double flag = words.number(what);
  if (flag != 0 && flag != 1) words.fail(std::to_string(flag), std::string("0 or 1 (") + what + ")");
  return flag == 1;
}

Rgb readSpectrum(WordReader& words) {
  std::vector<double> wavelengths, percents;
  for (std::size_t count = words.count("wavelengths"); count > 0; --count) {
    wavelengths.push_back(words.number("wavelength"));
    percents.push_back(words.number("percent of reflected light"));
    if (wavelengths.size() > 1 && !(wavelengths.back() > wavelengths[wavelengths.size() - 2]))
      throw Error("found the wavelength " + std::to_string(wavelengths.back()) + " after " +
                  std::to_string(wavelengths[wavelengths.size() - 2]) + ", expected ascending wavelengths");
  }
  const std::vector<Rgb> weights = spectrumWeights(wavelengths);
  Rgb sum(0);
  for (std::size_t i = 0; i < percents.size(); ++i) sum += weights[i] * (percents[i] / 100);
  return sum;
}

SpeosBlock readBlock(WordReader& words, double rotation, double incident) {
  SpeosBlock block{rotation, incident, {}, {}, {}};
  const std::size_t polars = words.count("polar angles"), azimuths = words.count("azimuths");
  block.azimuths = words.numbers(azimuths, "azimuth");
  for (std::size_t polar = 0; polar < polars; ++polar) {
    block.polars.push_back(words.number("polar angle"));
    const std::vector<double> row = words.numbers(azimuths, "a value of the block");
    block.values.insert(block.values.end(), row.begin(), row.end());
  }
  if (!std::ranges::is_sorted(block.azimuths) || !std::ranges::is_sorted(block.polars))
    throw Error("found angles of the incidence " + std::to_string(incident) +
                " that do not ascend, expected ascending angles");
  return block;
}

SpeosFile readFile(WordReader& words) {
  SpeosFile file;
  if (flagOf(words, "binary")) throw Error("found binary data, expected text: binary Speos files are not read");
  for (int i = 0; i < 3; ++i) words.number("axis of the anisotropy");
  const bool isReflection = flagOf(words, "reflection"), isTransmission = flagOf(words, "transmission");
  if (!isReflection || isTransmission)
    throw io::FormatMismatch(isReflection ? "reflection and transmission" : "transmission", "reflection alone");
  file.isIntensity = !flagOf(words, "values of BSDF");
  const std::vector<double> rotations = words.numbers(words.count("sample rotations"), "sample rotation");
  std::vector<std::vector<double>> incidents;
  for (std::size_t i = 0; i < rotations.size(); ++i)
    incidents.push_back(words.numbers(words.count("angles of incidence"), "angle of incidence"));
  file.spectrumTheta = words.number("incidence of the spectrum");
  words.number("azimuth of the spectrum");
  file.reflected = readSpectrum(words);
  for (std::size_t i = 0; i < rotations.size(); ++i)
    for (const double incident : incidents[i]) file.blocks.push_back(readBlock(words, rotations[i], incident));
  if (const std::string_view word = words.word("End of file"); word != "End") words.fail(word, "End of file");
  return file;
}

/// Integral by trapezoids, divided by the length; the value itself of one node.
template <typename Value>
double meanOver(const std::vector<double>& nodes, const Value& value) {
  const double length = nodes.back() - nodes.front();
  if (!(length > 0)) return value(0);
  double sum = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) sum += (nodes[i] - nodes[i - 1]) * (value(i - 1) + value(i)) / 2;
  return sum / length;
}

/// The light that a block reflects, in units of its values: their integral over the projected solid angle.
double reflectedBy(const SpeosBlock& block, bool isIntensity) {
  const double range = radians(block.polars.back() - block.polars.front());
  return 2 * pi * range * meanOver(block.polars, [&](std::size_t polar) {
           const double theta = radians(block.polars[polar]);
           const double mean = meanOver(block.azimuths, [&](std::size_t azimuth) { return block.at(polar, azimuth); });
           return mean * std::sin(theta) * (isIntensity ? 1 : std::max(std::cos(theta), 0.0));
         });
}

/// The colour of a value of 1.
Rgb scaleOf(const SpeosFile& file) {
  const auto found = std::ranges::find(file.blocks, file.spectrumTheta, &SpeosBlock::incident);
  if (found == file.blocks.end())
    throw Error("found a spectrum at the incidence " + std::to_string(file.spectrumTheta) +
                " degrees, expected one of the angles of incidence");
  const double reflected = reflectedBy(*found, file.isIntensity);
  if (!(reflected > 0))
    throw Error("found no reflected light at the incidence of the spectrum, expected values above 0");
  return file.reflected / reflected;
}

void sniffSpeos(const io::ByteSource& source) {
  std::string head(std::size_t(std::min<std::uint64_t>(source.size(), 64)), '\0');
  source.readAt(0, std::as_writable_bytes(std::span(head)));
  if (!io::withoutByteOrderMark(head).starts_with(speosStart)) throw io::FormatMismatch("another start", expectedSpeos);
}

constexpr std::string_view speosSuffixes[] = {".anisotropicbsdf"};

}  // namespace

ScatteredSamples readSpeos(const io::ByteSource& source) {
  const std::string text = withoutFreeText(io::allText(source));
  WordReader words(text);
  const SpeosFile file = readFile(words);
  const Rgb scale = scaleOf(file);
  ScatteredSamples samples;
  for (const SpeosBlock& block : file.blocks) {
    const double mirror = radians(-block.rotation);
    const Direction wi = fromSpherical(radians(block.incident), mirror + pi);
    for (std::size_t polar = 0; polar < block.polars.size(); ++polar)
      for (std::size_t azimuth = 0; azimuth < block.azimuths.size(); ++azimuth) {
        const Direction wo = fromSpherical(radians(block.polars[polar]), mirror + radians(block.azimuths[azimuth]));
        const bool isDivided = file.isIntensity && wo.z > horizonTolerance;
        const Rgb value = scale * (block.at(polar, azimuth) / (isDivided ? wo.z : 1));
        if (!std::isfinite(value.x + value.y + value.z))
          throw Error("found the value " + std::to_string(block.at(polar, azimuth)) +
                      ", expected values that give a finite BRDF");
        samples.add({wi, wo}, value);
      }
  }
  if (samples.values.empty())
    throw Error("found no direction above the horizon, expected polar angles below 90 degrees");
  samples.notes.push_back(
      "read as: angles in degrees; " + std::string(file.isIntensity ? "intensity, divided by cos theta" : "BSDF") +
      ", scaled so that the incidence of the spectrum reflects its percentage; " + words.notation().text());
  return samples;
}

constinit const MaterialFormat speosFormat{.name = "Speos",
                                           .label = "Ansys Speos anisotropic BSDF",
                                           .suffixes = speosSuffixes,
                                           .holds = {.nonReciprocal = true, .anisotropic = true},
                                           .sniff = sniffSpeos,
                                           .read = readPoints<readSpeos>};

}  // namespace gonio::formats
