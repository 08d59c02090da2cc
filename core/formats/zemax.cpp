// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <cmath>
#include <map>

#include "core/formats/formats.h"
#include "core/formats/scatter_table.h"
#include "core/io/byte_source.h"

/// Tabular BSDF files of Zemax OpticStudio (Rykowski 2008, "BSDF Data Interchange File Format Specification"), `.bsdf`:
///
///     Source Measured
///     Symmetry PlaneSymmetrical
///     SpectralContent Monochrome
///     ScatterType BRDF
///     SampleRotation 1
///     0
///     AngleOfIncidence 2
///     0 30
///     ScatterAzimuth 3
///     0 90 180
///     ScatterRadial 2
///     0 10
///     Monochrome
///     DataBegin
///     TIS 0.5
///     ..
///     DataEnd
///
/// Angles in degrees. The scattered direction is relative to the mirror direction: radial angle from it, azimuth
/// counter-clockwise with 0 toward the normal. There is a block per sample rotation and angle of incidence: the total
/// integrated scatter (not used), then one row per azimuth and one column per radial angle, BRDF in 1/sr, without the
/// cosine. With SpectralContent XYZ the blocks TristimulusX, TristimulusY and TristimulusZ follow one another, with D65
/// white at Y = 1. Lines that begin with # are comments.
///
/// A sample that is turned by its rotation, counter-clockwise about the normal, is lit from an azimuth that is less by
/// this angle. At rotation 0 the light travels along the tangent (x): it stands at azimuth 180 degrees, as in the files
/// of ua-loft/bsdf-tools; the specification leaves it open. Several rotations make the BRDF anisotropic.
namespace gonio::formats {

using materials::Material;

namespace {

const std::string expectedZemax = "the keys AngleOfIncidence and ScatterRadial (Zemax tabular BSDF)";

struct ZemaxHeader {
  ScatterHeader common;
  std::vector<double> rotations{0}, incident;  ///< degrees
};

void expectReflection(std::string_view type) {
  if (type != "BRDF") throw io::FormatMismatch("the scatter type '" + std::string(type) + "'", "reflection: BRDF");
}

/// Up to the name of the first channel, which is returned.
std::string_view readZemaxHeader(WordReader& words, ZemaxHeader& header) {
  for (;;) {
    const std::string_view key = words.word("the header up to Monochrome or TristimulusX");
    if (header.common.readKey(key, words)) continue;
    if (key == "Monochrome" || key.starts_with("Tristimulus")) return key;
    if (key == "ScatterType")
      expectReflection(words.word("the scatter type"));
    else if (key == "SampleRotation")
      header.rotations = words.numbers(words.count("sample rotations"), "sample rotation");
    else if (key == "AngleOfIncidence")
      header.incident = words.numbers(words.count("angles of incidence"), "angle of incidence");
    else
      words.skipLine();
  }
}

std::size_t channelOf(std::string_view name, const ZemaxHeader& header, const WordReader& words) {
  const bool isXyz = header.common.content == SpectralContent::xyz;
  for (std::size_t channel = 0; isXyz && channel < 3; ++channel)
    if (name == std::string("Tristimulus") + "XYZ"[channel]) return channel;
  if (isXyz || name != "Monochrome")
    words.fail(name, isXyz ? "TristimulusX, TristimulusY or TristimulusZ" : "Monochrome");
  return 0;
}

/// The blocks of one channel, between DataBegin and DataEnd.
/// @param blocks [rotation][incident].
void readChannel(WordReader& words, const ZemaxHeader& header, std::size_t channel, std::vector<ScatterBlock>& blocks) {
  if (const std::string_view word = words.word("DataBegin"); word != "DataBegin") words.fail(word, "DataBegin");
  for (ScatterBlock& block : blocks) {
    if (const std::string_view word = words.word("TIS"); word != "TIS") words.fail(word, "TIS");
    words.number("total integrated scatter");
    block.add(channel, words.numbers(header.common.values(), "a value of the block"));
  }
  if (const std::string_view word = words.word("DataEnd"); word != "DataEnd") words.fail(word, "DataEnd");
}

/// The azimuths of the light in [0, 2 pi), ascending, and the rotations that have them: 0 and 360 degrees are one.
std::map<double, std::vector<std::size_t>> lightAzimuths(const std::vector<double>& rotations) {
  std::map<double, std::vector<std::size_t>> result;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    double azimuth = std::fmod(180 - rotations[i], 360);
    if (azimuth < 0) azimuth += 360;
    result[radians(azimuth)].push_back(i);
  }
  return result;
}

/// @param blocks [rotation][incident].
IncidenceTable zemaxTable(const ZemaxHeader& header, const std::vector<ScatterBlock>& blocks) {
  IncidenceTable table{.axis = IncidenceTable::Axis::mirror,
                       .symmetric = header.common.symmetry == ScatterSymmetry::plane,
                       .incident = inRadians(header.incident),
                       .azimuths = inRadians(header.common.azimuths),
                       .polars = inRadians(header.common.radials),
                       .values = {},
                       .rotations = {}};
  const std::size_t incidents = header.incident.size();
  for (const auto& [azimuth, rotations] : lightAzimuths(header.rotations)) {
    table.rotations.push_back(azimuth);
    for (std::size_t incident = 0; incident < incidents; ++incident) {
      ScatterBlock mean;
      for (const std::size_t rotation : rotations) mean.add(blocks[rotation * incidents + incident]);
      const std::vector<glm::vec3> colours = mean.colours(header.common);
      table.values.insert(table.values.end(), colours.begin(), colours.end());
    }
  }
  // An isotropic material may be lit from anywhere.
  if (table.rotations.size() == 1) table.rotations = {0};
  return table;
}

/// @throws io::FormatMismatch if the keys AngleOfIncidence and ScatterRadial are not in the first 64 KiB of text.
void sniffZemax(const io::ByteSource& source) {
  const std::string head = io::textHead(source, expectedZemax);
  if (!hasKey(head, "AngleOfIncidence") || !hasKey(head, "ScatterRadial"))
    throw io::FormatMismatch("a text file of another format", expectedZemax);
}

/// @throws io::FormatMismatch for a file of transmission (BTDF); Error that names the line.
void readZemax(const io::ByteSource& source, const TaskControl& control, Material& material) {
  control.throwIfStopped();
  const std::string text = io::allText(source);
  WordReader words(text);
  ZemaxHeader header;
  std::string_view name = readZemaxHeader(words, header);
  header.common.check();
  if (header.incident.empty()) throw Error("found no AngleOfIncidence before the data, expected its angles");
  // A value takes two bytes or more.
  const double values =
      double(header.rotations.size()) * double(header.incident.size()) * double(header.common.values());
  if (values > double(text.size()) / 2)
    throw Error("found " + std::to_string(header.rotations.size()) + " sample rotations, " +
                std::to_string(header.incident.size()) + " angles of incidence and " +
                std::to_string(header.common.values()) + " values of each, expected a file of more than " +
                std::to_string(text.size()) + " bytes");
  std::vector<ScatterBlock> blocks(header.rotations.size() * header.incident.size());
  for (; !name.empty(); name = words.next()) readChannel(words, header, channelOf(name, header, words), blocks);
  IncidenceTable table = zemaxTable(header, blocks);
  if (table.rotations.size() > 1)
    material.source.notes.push_back(std::to_string(table.rotations.size()) +
                                    " sample rotations: the material is anisotropic; at rotation 0 the light is at "
                                    "azimuth 180 degrees");
  setIncidenceTable(std::move(table), header.common, words.notation(), material);
}

constexpr std::string_view zemaxSuffixes[] = {".bsdf"};

}  // namespace

constinit const MaterialFormat zemaxFormat{.name = "Zemax",
                                           .label = "Zemax BSDF",
                                           .suffixes = zemaxSuffixes,
                                           .isMeasurement = true,
                                           .holds = {.nonReciprocal = true, .anisotropic = true},
                                           .sniff = sniffZemax,
                                           .read = readZemax};

}  // namespace gonio::formats
