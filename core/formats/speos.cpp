// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>

#include "core/formats/formats.h"
#include "core/formats/scatter_table.h"
#include "core/formats/scattered_samples.h"
#include "core/io/byte_source.h"
#include "core/math/colour.h"
#include "core/support/text.h"

/// Text files of measured surfaces of Ansys Speos (OPTIS). Anisotropic ones, `.anisotropicbsdf`, versions 7 and 8:
///
///     OPTIS - Anisotropic BSDF surface file v8.0
///     0                           text, not binary
///     Comment
///     23                          characters of the description, in one or more lines
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
///     3 2                         a table for each rotation and incidence: polar angles and azimuths
///         0   180                 azimuths
///     0   0.2 0.2                 polar angle and values
///     ..
///     End of file
///
/// Spectral ones ("complete scattering"), `.brdf`, version 9, are the same to the description; then
///
///     1 0                         whether there is reflection, transmission
///     1                           values: 1 BSDF, 0 intensity
///     2 3                         angles of incidence, wavelengths
///     0 30
///     450 550 650
///     20                          for each incidence, and in it for each wavelength: percent of reflected light,
///     3 2                         and a table as above
///     ..
///
/// Degrees. Polar angles are about the normal; azimuth 0 is on the side of the mirror direction. Values are relative:
/// in anisotropic files one factor scales all tables so that the table of the spectrum reflects its percentage, of
/// which the spectrum colours all directions alike; in spectral files each table reflects its own percentage. Sources:
/// Ansys Speos help, "Structure of Anisotropic BSDF Files" and "Structure of BRDF files", for the rows of text files;
/// the converters of ansys/optical-automation for azimuth 0, with whose pair of files of one material in both formats
/// (Zemax and Speos) this agrees. Rotations are those of Zemax files. The layout of binary files is not published.
namespace gonio::formats {

namespace {

constexpr std::string_view anisotropicStart = "optis - anisotropic bsdf surface file",
                           spectralStart = "optis - brdf surface file";
const std::string expectedSpeos =
    "a first line 'OPTIS - Anisotropic BSDF surface file' or 'OPTIS - brdf surface file' (Ansys Speos)";

std::string headOf(const io::ByteSource& source) {
  std::string head(std::size_t(std::min<std::uint64_t>(source.size(), 64)), '\0');
  source.readAt(0, std::as_writable_bytes(std::span(head)));
  return lowerCase(std::string(io::withoutByteOrderMark(head)));
}

/// Whether the second line has the mode 1, as text or as a number of its bytes.
bool isBinary(std::string_view head) {
  const std::size_t end = std::min(head.find('\n'), head.size());
  const std::size_t mode = head.find_first_not_of(" \t\r\n", end);
  return mode != std::string_view::npos && (head[mode] == '1' || (head[mode] >= 0 && head[mode] < ' '));
}

/// The text with spaces in its first line, the comment and the description: every other word is a number, in its line.
std::string withoutFreeText(std::string text) {
  constexpr std::size_t commentLine = 3, countLine = 4, descriptionLine = 5;
  std::size_t begin = 0, described = 0;
  for (std::size_t line = 1; line <= descriptionLine && begin < text.size(); ++line) {
    std::size_t end = std::min(text.find('\n', begin), text.size());
    if (line == countLine) {
      const std::vector<std::string_view> words = io::words(std::string_view(text).substr(begin, end - begin));
      const auto count = words.empty() ? std::nullopt : io::finiteNumber(words[0]);
      if (count && *count > 0) described = std::size_t(std::min(*count, double(text.size())));
    }
    // The count may include the last line break.
    if (line == descriptionLine && described > 0)
      end = std::min(text.find('\n', std::min(begin + described - 1, text.size())), text.size());
    if (line == 1 || line >= commentLine)
      for (char& c : std::span(text).subspan(begin, end - begin))
        if (c != '\n') c = ' ';
    begin = end + 1;
  }
  return text;
}

/// The values of one incidence, relative; of one wavelength or of all.
struct SpeosTable {
  std::vector<double> azimuths, polars;  ///< degrees
  std::vector<double> values;            ///< [polar][azimuth]

  double at(std::size_t polar, std::size_t azimuth) const { return values[polar * azimuths.size() + azimuth]; }
};

/// Tables of the same angles, each with the colour of a value of 1.
struct SpeosIncidence {
  double rotation = 0, incident = 0;  ///< degrees
  std::vector<SpeosTable> tables;
  std::vector<Rgb> colours;

  Rgb at(std::size_t polar, std::size_t azimuth) const {
    Rgb sum(0);
    for (std::size_t i = 0; i < tables.size(); ++i) sum += tables[i].at(polar, azimuth) * colours[i];
    return sum;
  }
};

struct SpeosFile {
  bool isIntensity = false;
  std::string scaling;  ///< for notes
  std::vector<SpeosIncidence> incidences;
};

bool flagOf(WordReader& words, const char* what) {
  const double flag = words.number(what);
  if (flag != 0 && flag != 1) words.fail(std::to_string(flag), std::string("0 or 1 (") + what + ")");
  return flag == 1;
}

/// Whether the values are intensities. @throws io::FormatMismatch for transmission.
bool readIsIntensity(WordReader& words) {
  const bool isReflection = flagOf(words, "reflection"), isTransmission = flagOf(words, "transmission");
  if (!isReflection || isTransmission)
    throw io::FormatMismatch(isReflection ? "reflection and transmission" : "transmission", "reflection alone");
  return !flagOf(words, "values of BSDF");
}

void checkAscending(const std::vector<double>& wavelengths) {
  for (std::size_t i = 1; i < wavelengths.size(); ++i)
    if (!(wavelengths[i] > wavelengths[i - 1]))
      throw Error("found the wavelength " + numberText(wavelengths[i]) + " after " + numberText(wavelengths[i - 1]) +
                  ", expected ascending wavelengths");
}

Rgb readSpectrum(WordReader& words) {
  std::vector<double> wavelengths, percents;
  for (std::size_t count = words.count("wavelengths"); count > 0; --count) {
    wavelengths.push_back(words.number("wavelength"));
    percents.push_back(words.number("percent of reflected light"));
  }
  checkAscending(wavelengths);
  const std::vector<Rgb> weights = spectrumWeights(wavelengths);
  Rgb sum(0);
  for (std::size_t i = 0; i < percents.size(); ++i) sum += weights[i] * (percents[i] / 100);
  return sum;
}

SpeosTable readTable(WordReader& words, double incident) {
  SpeosTable table;
  const std::size_t polars = words.count("polar angles"), azimuths = words.count("azimuths");
  table.azimuths = words.numbers(azimuths, "azimuth");
  for (std::size_t polar = 0; polar < polars; ++polar) {
    table.polars.push_back(words.number("polar angle"));
    const std::vector<double> row = words.numbers(azimuths, "a value of the block");
    table.values.insert(table.values.end(), row.begin(), row.end());
  }
  if (!std::ranges::is_sorted(table.azimuths) || !std::ranges::is_sorted(table.polars))
    throw Error("found angles of the incidence " + numberText(incident) +
                " that do not ascend, expected ascending angles");
  return table;
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

/// The light that a table reflects, in units of its values: their integral over the projected solid angle.
double reflectedBy(const SpeosTable& table, bool isIntensity) {
  const double range = radians(table.polars.back() - table.polars.front());
  return 2 * pi * range * meanOver(table.polars, [&](std::size_t polar) {
           const double theta = radians(table.polars[polar]);
           const double mean = meanOver(table.azimuths, [&](std::size_t azimuth) { return table.at(polar, azimuth); });
           return mean * std::sin(theta) * (isIntensity ? 1 : std::max(std::cos(theta), 0.0));
         });
}

/// The factor of the values of a table that reflects a fraction of the light.
double scaleOf(const SpeosTable& table, bool isIntensity, double incident) {
  const double reflected = reflectedBy(table, isIntensity);
  if (!(reflected > 0))
    throw Error("found no reflected light at the incidence " + numberText(incident) +
                " degrees, expected values above 0");
  return 1 / reflected;
}

/// The factor at the incidence of the spectrum: between two angles of incidence, or at the first or last one.
double scaleAt(const SpeosFile& file, double theta) {
  const double rotation = file.incidences[0].rotation;
  const SpeosIncidence *below = nullptr, *above = nullptr;
  for (const SpeosIncidence& one : file.incidences) {
    if (one.rotation != rotation) continue;
    if (one.incident <= theta && (!below || one.incident > below->incident)) below = &one;
    if (one.incident >= theta && (!above || one.incident < above->incident)) above = &one;
  }
  if (!below) below = above;
  if (!above) above = below;
  const auto scale = [&](const SpeosIncidence& one) { return scaleOf(one.tables[0], file.isIntensity, one.incident); };
  if (below->incident == above->incident) return scale(*below);
  const double fraction = (theta - below->incident) / (above->incident - below->incident);
  return (1 - fraction) * scale(*below) + fraction * scale(*above);
}

SpeosFile readAnisotropic(WordReader& words) {
  SpeosFile file;
  for (int i = 0; i < 3; ++i) words.number("axis of the anisotropy");
  file.isIntensity = readIsIntensity(words);
  const std::vector<double> rotations = words.numbers(words.count("sample rotations"), "sample rotation");
  std::vector<std::vector<double>> incidents;
  for (std::size_t i = 0; i < rotations.size(); ++i)
    incidents.push_back(words.numbers(words.count("angles of incidence"), "angle of incidence"));
  const double spectrumTheta = words.number("incidence of the spectrum");
  words.number("azimuth of the spectrum");
  const Rgb reflected = readSpectrum(words);
  for (std::size_t i = 0; i < rotations.size(); ++i)
    for (const double incident : incidents[i])
      file.incidences.push_back({rotations[i], incident, {readTable(words, incident)}, {}});
  if (const std::string_view word = words.word("End of file"); word != "End") words.fail(word, "End of file");
  const double scale = scaleAt(file, spectrumTheta);
  for (SpeosIncidence& one : file.incidences) one.colours = {reflected * scale};
  file.scaling = "the incidence of the spectrum reflects its percentage";
  return file;
}

SpeosFile readSpectral(WordReader& words) {
  SpeosFile file{.isIntensity = readIsIntensity(words), .scaling = {}, .incidences = {}};
  const std::size_t count = words.count("angles of incidence"), spectral = words.count("wavelengths");
  const std::vector<double> incidents = words.numbers(count, "angle of incidence"),
                            wavelengths = words.numbers(spectral, "wavelength");
  checkAscending(wavelengths);
  const std::vector<Rgb> weights = spectrumWeights(wavelengths);
  for (const double incident : incidents) {
    SpeosIncidence& one = file.incidences.emplace_back();
    one.incident = incident;
    for (const Rgb& weight : weights) {
      const double percent = words.number("percent of reflected light");
      one.tables.push_back(readTable(words, incident));
      const SpeosTable &first = one.tables[0], &table = one.tables.back();
      if (table.azimuths != first.azimuths || table.polars != first.polars)
        throw Error("found other angles at another wavelength of the incidence " + numberText(incident) +
                    ", expected the same for all wavelengths");
      const double scale = percent == 0 ? 0 : scaleOf(table, file.isIntensity, incident);
      one.colours.push_back(weight * (percent / 100 * scale));
    }
  }
  if (const std::string_view word = words.next(); !word.empty() && word != "End")
    words.fail(word, "the end of the file");
  file.scaling = "each of the " + std::to_string(spectral) + " wavelengths reflects its percentage";
  return file;
}

void sniffSpeos(const io::ByteSource& source) {
  const std::string head = headOf(source);
  if (!head.starts_with(anisotropicStart) && !head.starts_with(spectralStart))
    throw io::FormatMismatch("another start", expectedSpeos);
}

constexpr std::string_view speosSuffixes[] = {".anisotropicbsdf", ".brdf"};

}  // namespace

ScatteredSamples readSpeos(const io::ByteSource& source) {
  const std::string head = headOf(source);
  if (isBinary(head))
    throw Error(
        "found binary data, expected text: binary Speos files are not read, since their layout is not published");
  const std::string text = withoutFreeText(io::allText(source));
  WordReader words(text);
  flagOf(words, "mode: text");
  const SpeosFile file = head.starts_with(spectralStart) ? readSpectral(words) : readAnisotropic(words);
  ScatteredSamples samples;
  for (const SpeosIncidence& one : file.incidences) {
    const double mirror = radians(-one.rotation);
    const Direction wi = fromSpherical(radians(one.incident), mirror + pi);
    const SpeosTable& grid = one.tables[0];
    for (std::size_t polar = 0; polar < grid.polars.size(); ++polar)
      for (std::size_t azimuth = 0; azimuth < grid.azimuths.size(); ++azimuth) {
        const Direction wo = fromSpherical(radians(grid.polars[polar]), mirror + radians(grid.azimuths[azimuth]));
        const bool isDivided = file.isIntensity && wo.z > horizonTolerance;
        const Rgb value = one.at(polar, azimuth) / (isDivided ? wo.z : 1);
        if (!std::isfinite(value.x + value.y + value.z))
          throw Error("found the value " + numberText(grid.at(polar, azimuth)) +
                      ", expected values that give a finite BRDF");
        samples.add({wi, wo}, value);
      }
  }
  if (samples.values.empty())
    throw Error("found no direction above the horizon, expected polar angles below 90 degrees");
  samples.notes.push_back("read as: angles in degrees; " +
                          std::string(file.isIntensity ? "intensity, divided by cos theta" : "BSDF") +
                          ", scaled so that " + file.scaling + "; " + words.notation().text());
  return samples;
}

constinit const MaterialFormat speosFormat{.name = "Speos",
                                           .label = "Ansys Speos BSDF",
                                           .suffixes = speosSuffixes,
                                           .holds = {.nonReciprocal = true, .anisotropic = true},
                                           .sniff = sniffSpeos,
                                           .read = readPoints<readSpeos>};

}  // namespace gonio::formats
