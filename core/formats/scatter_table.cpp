// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/formats/scatter_table.h"

#include <algorithm>
#include <cmath>

#include "core/math/colour.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::formats {

namespace {

/// A digit and a separator.
constexpr std::size_t minBytesOfNumber = 2;

}  // namespace

std::string_view WordReader::next() {
  while (words_.empty()) {
    const auto line = lines_.next();
    if (!line) return {};
    words_ = io::words(io::withoutComment(line->text), notation_);
    std::ranges::reverse(words_);
  }
  const std::string_view result = words_.back();
  words_.pop_back();
  return result;
}

std::string_view WordReader::word(const char* what) {
  const std::string_view result = next();
  if (result.empty()) throw Error("line " + std::to_string(lines_.number()) + ": the file ends, expected " + what);
  return result;
}

double WordReader::number(const char* what) {
  const std::string_view text = word(what);
  const auto value = io::finiteNumber(text, notation_);
  if (!value) fail(text, std::string("a finite number (") + what + ")");
  return *value;
}

std::size_t WordReader::count(const char* what) {
  const std::string_view text = word(what);
  const auto value = io::finiteNumber(text, notation_);
  const std::size_t most = lines_.bytesLeft() / minBytesOfNumber + words_.size() + 1;
  if (!value || !(*value >= 1) || *value != std::floor(*value) || *value > double(most))
    fail(text, std::string("the number of values that follow (") + what + ")");
  return std::size_t(*value);
}

std::vector<double> WordReader::numbers(std::size_t numbers, const char* what) {
  const std::size_t most = lines_.bytesLeft() / minBytesOfNumber + words_.size() + 1;
  if (numbers > most)
    throw Error("line " + std::to_string(lines_.number()) + ": the rest of the file has room for at most " +
                std::to_string(most) + " numbers, expected " + std::to_string(numbers) + " (" + what + ")");
  std::vector<double> result(numbers);
  for (double& value : result) value = number(what);
  return result;
}

void WordReader::fail(std::string_view word, const std::string& expected) const {
  io::TextLine{lines_.number(), word}.fail(expected);
}

bool ScatterHeader::readKey(std::string_view key, WordReader& words) {
  if (key == "Symmetry") {
    const std::string_view word = words.word("the symmetry");
    const std::string name = lowerCase(std::string(word));
    if (name.starts_with("plane"))
      symmetry = ScatterSymmetry::plane;
    else if (name.starts_with("asymmetric"))
      symmetry = ScatterSymmetry::none;
    else
      words.fail(word, "PlaneSymmetrical, Asymmetrical or Asymmetrical4D");
  } else if (key == "SpectralContent") {
    const std::string_view word = words.word("the spectral content");
    if (word != "Monochrome" && word != "XYZ") words.fail(word, "Monochrome or XYZ");
    content = word == "XYZ" ? SpectralContent::xyz : SpectralContent::monochrome;
  } else if (key == "ScatterAzimuth") {
    azimuths = words.numbers(words.count("azimuths"), "azimuth");
  } else if (key == "ScatterRadial") {
    radials = words.numbers(words.count("radial angles"), "radial angle");
  } else {
    return false;
  }
  return true;
}

void ScatterHeader::check() const {
  if (azimuths.empty() || radials.empty())
    throw Error(std::string("found no ") + (azimuths.empty() ? "ScatterAzimuth" : "ScatterRadial") +
                " before the data, expected its angles");
}

void ScatterBlock::add(std::size_t channel, std::span<const double> values) {
  sums[channel].resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) sums[channel][i] += values[i];
  ++counts[channel];
}

void ScatterBlock::add(const ScatterBlock& other) {
  for (std::size_t channel = 0; channel < sums.size(); ++channel) {
    if (other.counts[channel] == 0) continue;
    add(channel, other.sums[channel]);
    counts[channel] += other.counts[channel] - 1;
  }
}

std::vector<glm::vec3> ScatterBlock::colours(const ScatterHeader& header) const {
  for (std::size_t channel = 0; channel < header.channels(); ++channel)
    if (counts[channel] == 0)
      throw Error("found no values of channel " + std::to_string(channel + 1) +
                  " for an angle of incidence, expected values of every channel");
  std::vector<glm::vec3> result;
  result.reserve(header.values());
  for (std::size_t i = 0; i < header.values(); ++i) {
    const auto mean = [&](std::size_t channel) { return sums[channel][i] / counts[channel]; };
    result.emplace_back(header.content == SpectralContent::xyz ? linearSrgb({mean(0), mean(1), mean(2)})
                                                               : Rgb(mean(0)));
  }
  return result;
}

bool hasKey(std::string_view text, std::string_view key) {
  io::TextLines lines(text);
  while (const auto line = lines.next())
    if (const auto all = io::words(line->text); !all.empty() && all[0] == key) return true;
  return false;
}

std::vector<double> inRadians(const std::vector<double>& angles) {
  std::vector<double> result = angles;
  for (double& angle : result) angle = radians(angle);
  return result;
}

void setIncidenceTable(IncidenceTable table, const ScatterHeader& header, const io::NumberNotation& notation,
                       materials::Material& material) {
  material.source.notes.push_back(
      std::string("read as: angles in degrees; BRDF in 1/sr, ") +
      (header.content == SpectralContent::xyz ? "X, Y, Z (white of D65 at Y = 1)" : "monochrome as grey") + "; " +
      notation.text());
  material.source.grid = {int(table.incident.size()), int(table.azimuths.size()), int(table.polars.size())};
  if (table.rotations.size() > 1)
    material.source.grid.insert(material.source.grid.begin(), int(table.rotations.size()));
  const auto brdf = std::make_shared<const IncidenceTableBrdf>(std::move(table));
  if (brdf->clampedCount() > 0)
    material.source.notes.push_back(std::to_string(brdf->clampedCount()) + " negative values were set to 0");
  material.brdf = brdf;
}

}  // namespace gonio::formats
