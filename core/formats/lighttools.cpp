// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/formats/formats.h"
#include "core/formats/scatter_table.h"
#include "core/io/byte_source.h"

/// BSDF text files of LightTools (Synopsys), `.bsdf`, in the layout that libbsdf (Kimura 2015) reads:
///
///     Symmetry Asymmetric
///     SpectralContent Monochrome
///     ScatterAzimuth 4
///     0 90 180 270
///     ScatterRadial 3
///     0 30 60
///     DataBegin
///     AOI 10
///     POI 0
///     Side Front
///     Wavelength 550
///     ScatterType BRDF
///     TIS 0.5
///     ..
///     DataEnd
///
/// Angles in degrees. Unlike in Zemax files, the scattered direction is given about the normal: ScatterRadial is its
/// polar angle, ScatterAzimuth its azimuth; the light is at the azimuth POI + 90 degrees. With the symmetry
/// PlaneSymmetrical one side of the plane of incidence is sufficient. There is a block per angle of incidence (AOI; at
/// most 90 degrees), with one row per azimuth and one column per polar angle: BRDF in 1/sr, without the cosine. With
/// SpectralContent XYZ a block states its TristimulusValue TrisX, TrisY or TrisZ. Blocks of the back and of
/// transmission are ignored; several wavelengths are averaged. Lines that begin with # are comments.
namespace gonio::formats {

using materials::Material;

namespace {

const std::string expectedLightTools = "the keys ScatterRadial and AOI (LightTools BSDF)";

/// Azimuth of the light, degrees.
constexpr double lightAzimuth = 90;

/// The keys before the values of a block. Keys that a block lacks are those of the block before.
struct BlockHeader {
  double incident = 0, plane = 0;
  bool isFront = true, isReflection = true;
  std::size_t channel = 0;
  std::optional<double> wavelength;  ///< nm
};

/// All blocks of the front's reflection.
struct Blocks {
  std::map<double, ScatterBlock> byIncident;  ///< degrees
  std::optional<double> plane;                ///< POI of all of them, degrees
  std::set<double> wavelengths;               ///< nm
  std::size_t leftOut = 0;
};

void readLightToolsHeader(WordReader& words, ScatterHeader& header) {
  for (;;) {
    const std::string_view key = words.word("the header up to DataBegin");
    if (key == "DataBegin") return header.check();
    if (!header.readKey(key, words)) words.skipLine();
  }
}

template <std::size_t N>
std::size_t choice(WordReader& words, const char* what, const std::array<std::string_view, N>& names) {
  const std::string_view word = words.word(what);
  const auto found = std::ranges::find(names, word);
  if (found == names.end()) words.fail(word, what);
  return std::size_t(found - names.begin());
}

/// A key of a block; TIS is its last one.
void readKey(std::string_view key, WordReader& words, BlockHeader& block) {
  if (key == "AOI")
    block.incident = words.number("angle of incidence");
  else if (key == "POI")
    block.plane = words.number("plane of incidence");
  else if (key == "Side")
    block.isFront = choice<2>(words, "Front or Back", {"Front", "Back"}) == 0;
  else if (key == "Wavelength")
    block.wavelength = words.number("wavelength");
  else if (key == "ScatterType")
    block.isReflection = choice<2>(words, "BRDF or BTDF", {"BRDF", "BTDF"}) == 0;
  else if (key == "TristimulusValue")
    block.channel = choice<3>(words, "TrisX, TrisY or TrisZ", {"TrisX", "TrisY", "TrisZ"});
  else
    words.fail(key, "a key of a block (AOI, POI, Side, Wavelength, ScatterType, TristimulusValue, TIS) or DataEnd");
}

void addBlock(const BlockHeader& block, const ScatterHeader& header, std::span<const double> values, Blocks& blocks) {
  if (!block.isFront || !block.isReflection) {
    ++blocks.leftOut;
    return;
  }
  if (blocks.plane.value_or(block.plane) != block.plane)
    throw io::FormatMismatch("blocks of several planes of incidence (POI)",
                             "one plane of incidence (isotropic materials only)");
  blocks.plane = block.plane;
  if (block.wavelength) blocks.wavelengths.insert(*block.wavelength);
  blocks.byIncident[block.incident].add(std::min(block.channel, header.channels() - 1), values);
}

Blocks readBlocks(WordReader& words, const ScatterHeader& header) {
  Blocks blocks;
  BlockHeader block;
  for (;;) {
    const std::string_view key = words.word("a block of values or DataEnd");
    if (key == "DataEnd") return blocks;
    if (key != "TIS") {
      readKey(key, words, block);
      continue;
    }
    words.number("total integrated scatter");
    addBlock(block, header, words.numbers(header.values(), "a value of the block"), blocks);
  }
}

/// Positions of the azimuths as they ascend from that of the light, and these in degrees; each direction once. The two
/// sides of the plane of incidence are one where they are symmetric.
std::map<double, std::size_t> azimuthsFromLight(const ScatterHeader& header, double plane) {
  std::map<double, std::size_t> order;
  for (std::size_t i = 0; i < header.azimuths.size(); ++i) {
    double from = std::fmod(header.azimuths[i] - plane - lightAzimuth, 360);
    if (from < 0) from += 360;
    if (header.symmetry == ScatterSymmetry::plane) from = std::min(from, 360 - from);
    order.emplace(from, i);
  }
  return order;
}

IncidenceTable lightToolsTable(const ScatterHeader& header, const Blocks& blocks) {
  IncidenceTable table{.axis = IncidenceTable::Axis::normal,
                       .symmetric = header.symmetry == ScatterSymmetry::plane,
                       .incident = {},
                       .azimuths = {},
                       .polars = inRadians(header.radials),
                       .values = {}};
  const auto order = azimuthsFromLight(header, *blocks.plane);
  for (const auto& [azimuth, position] : order) table.azimuths.push_back(radians(azimuth));
  const auto columns = std::ptrdiff_t(header.radials.size());
  for (const auto& [incident, block] : blocks.byIncident) {
    table.incident.push_back(radians(incident));
    const std::vector<glm::vec3> colours = block.colours(header);
    for (const auto& [azimuth, position] : order) {
      const auto row = colours.begin() + std::ptrdiff_t(position) * columns;
      table.values.insert(table.values.end(), row, row + columns);
    }
  }
  return table;
}

/// @throws io::FormatMismatch if the keys ScatterRadial and AOI are not in the first 64 KiB of text.
void sniffLightTools(const io::ByteSource& source) {
  const std::string head = io::textHead(source, expectedLightTools);
  if (!hasKey(head, "AOI") || !hasKey(head, "ScatterRadial"))
    throw io::FormatMismatch("a text file of another format", expectedLightTools);
}

/// @throws io::FormatMismatch for a file without reflection of the front, or with several planes of incidence
/// (anisotropic); Error that names the line.
void readLightTools(const io::ByteSource& source, const TaskControl& control, Material& material) {
  control.throwIfStopped();
  const std::string text = io::allText(source);
  WordReader words(text);
  ScatterHeader header;
  readLightToolsHeader(words, header);
  const Blocks blocks = readBlocks(words, header);
  if (blocks.byIncident.empty())
    throw io::FormatMismatch(std::to_string(blocks.leftOut) + " blocks with transmission or back-side data only",
                             "reflection: blocks with Side Front and ScatterType BRDF");
  std::vector<std::string>& notes = material.source.notes;
  if (blocks.leftOut > 0)
    notes.push_back(std::to_string(blocks.leftOut) + " blocks with transmission or back-side data were ignored");
  if (blocks.wavelengths.size() > 1)
    notes.push_back("values are the mean of " + std::to_string(blocks.wavelengths.size()) + " wavelengths");
  setIncidenceTable(lightToolsTable(header, blocks), header, words.notation(), material);
}

constexpr std::string_view lightToolsSuffixes[] = {".bsdf"};

}  // namespace

constinit const MaterialFormat lightToolsFormat{.name = "LightTools",
                                                .label = "LightTools BSDF",
                                                .suffixes = lightToolsSuffixes,
                                                .isMeasurement = true,
                                                .holds = {.nonReciprocal = true},
                                                .sniff = sniffLightTools,
                                                .read = readLightTools};

}  // namespace gonio::formats
