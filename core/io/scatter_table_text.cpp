// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/scatter_table_text.h"

#include "core/math/spectrum.h"
#include "core/support/error.h"
#include "core/support/lower_case.h"

namespace gonio::io {

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
  TextLines lines(text);
  while (const auto line = lines.next())
    if (const auto all = words(line->text); !all.empty() && all[0] == key) return true;
  return false;
}

std::vector<double> inRadians(const std::vector<double>& angles) {
  std::vector<double> result = angles;
  for (double& angle : result) angle = radians(angle);
  return result;
}

}  // namespace gonio::io
