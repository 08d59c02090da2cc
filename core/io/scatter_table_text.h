// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/brdf/incidence_table_brdf.h"
#include "core/io/word_reader.h"

/// Common parts of the text formats of optical design programs (Zemax, LightTools): a header of keys with lists of
/// angles in degrees, then blocks of values with one row per azimuth and one column per radial angle.
namespace gonio::io {

struct IncidenceFile {
  std::shared_ptr<const IncidenceTableBrdf> brdf;
  std::vector<std::string> notes;  ///< what the reader changed or ignored
};

enum class ScatterSymmetry { plane, none };
enum class SpectralContent { monochrome, xyz };

/// Keys of both formats.
struct ScatterHeader {
  ScatterSymmetry symmetry = ScatterSymmetry::plane;
  SpectralContent content = SpectralContent::monochrome;
  std::vector<double> azimuths, radials;  ///< degrees

  std::size_t channels() const { return content == SpectralContent::xyz ? 3 : 1; }
  /// Number of values in a block.
  std::size_t values() const { return azimuths.size() * radials.size(); }

  /// Reads the values of the keys Symmetry, SpectralContent, ScatterAzimuth and ScatterRadial. @return false for other
  /// keys. @throws Error that names the line.
  bool readKey(std::string_view key, WordReader& words);
  /// @throws Error if a list of angles is missing.
  void check() const;
};

/// Sums of the values of a file for one angle of incidence, over sample rotations and wavelengths.
struct ScatterBlock {
  std::array<std::vector<double>, 3> sums;  ///< per channel: monochrome in the first, or X, Y, Z; empty: no values
  std::array<int, 3> counts{};

  void add(std::size_t channel, std::span<const double> values);
  /// Means as linear sRGB, in the order of the values. @throws Error if a channel has no values.
  std::vector<glm::vec3> colours(const ScatterHeader& header) const;
};

/// Whether `key` is the first word of any line of the text.
bool hasKey(std::string_view text, std::string_view key);

/// Angles given in degrees, in rad.
std::vector<double> inRadians(const std::vector<double>& angles);

}  // namespace gonio::io
