// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
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
/// white at Y = 1. Sample rotations are averaged: the BRDF is isotropic. Lines that begin with # are comments.
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
void readChannel(WordReader& words, const ZemaxHeader& header, std::size_t channel, std::vector<ScatterBlock>& blocks) {
  if (const std::string_view word = words.word("DataBegin"); word != "DataBegin") words.fail(word, "DataBegin");
  for (std::size_t rotation = 0; rotation < header.rotations.size(); ++rotation)
    for (ScatterBlock& block : blocks) {
      if (const std::string_view word = words.word("TIS"); word != "TIS") words.fail(word, "TIS");
      words.number("total integrated scatter");
      block.add(channel, words.numbers(header.common.values(), "a value of the block"));
    }
  if (const std::string_view word = words.word("DataEnd"); word != "DataEnd") words.fail(word, "DataEnd");
}

IncidenceTable zemaxTable(const ZemaxHeader& header, const std::vector<ScatterBlock>& blocks) {
  IncidenceTable table{.axis = IncidenceTable::Axis::mirror,
                       .symmetric = header.common.symmetry == ScatterSymmetry::plane,
                       .incident = inRadians(header.incident),
                       .azimuths = inRadians(header.common.azimuths),
                       .polars = inRadians(header.common.radials),
                       .values = {}};
  for (const ScatterBlock& block : blocks) {
    const std::vector<glm::vec3> colours = block.colours(header.common);
    table.values.insert(table.values.end(), colours.begin(), colours.end());
  }
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
  std::vector<ScatterBlock> blocks(header.incident.size());
  for (; !name.empty(); name = words.next()) readChannel(words, header, channelOf(name, header, words), blocks);
  if (header.rotations.size() > 1)
    material.source.notes.push_back("values are the mean of " + std::to_string(header.rotations.size()) +
                                    " sample rotations; the material is treated as isotropic");
  setIncidenceTable(zemaxTable(header, blocks), header.common, words.notation(), material);
}

constexpr std::string_view zemaxSuffixes[] = {".bsdf"};

}  // namespace

constinit const MaterialFormat zemaxFormat{.name = "Zemax",
                                           .label = "Zemax BSDF",
                                           .suffixes = zemaxSuffixes,
                                           .isMeasurement = true,
                                           .holds = {.nonReciprocal = true},
                                           .sniff = sniffZemax,
                                           .read = readZemax};

}  // namespace gonio::formats
