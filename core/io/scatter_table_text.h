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

/// What the text formats of optical design programs share (Zemax, LightTools): a header of keys with lists of angles in
/// degrees, then blocks of values, a row an azimuth, a column a radial angle.
namespace gonio::io {

struct IncidenceFile {
  std::shared_ptr<const IncidenceTableBrdf> brdf;
  std::vector<std::string> notes;  ///< what the reader changed or left out
};

enum class ScatterSymmetry { plane, none };
enum class SpectralContent { monochrome, xyz };

/// Keys that both formats have.
struct ScatterHeader {
  ScatterSymmetry symmetry = ScatterSymmetry::plane;
  SpectralContent content = SpectralContent::monochrome;
  std::vector<double> azimuths, radials;  ///< degrees

  std::size_t channels() const { return content == SpectralContent::xyz ? 3 : 1; }
  /// Of a block.
  std::size_t values() const { return azimuths.size() * radials.size(); }

  /// Reads what follows the keys Symmetry, SpectralContent, ScatterAzimuth and ScatterRadial.
  /// @return whether it was one of them. @throws Error naming the line.
  bool readKey(std::string_view key, WordReader& words);
  /// @throws Error where a list of angles is missing.
  void check() const;
};

/// Sums of the values that a file has for one angle of incidence: of several sample rotations or wavelengths.
struct ScatterBlock {
  std::array<std::vector<double>, 3> sums;  ///< by channel: monochrome in the first, or X, Y, Z; empty: none
  std::array<int, 3> counts{};

  void add(std::size_t channel, std::span<const double> values);
  /// Means as linear sRGB, in the order of the values. @throws Error where a channel has none.
  std::vector<glm::vec3> colours(const ScatterHeader& header) const;
};

/// Whether the first word of a line of the text is `key`.
bool hasKey(std::string_view text, std::string_view key);

std::vector<double> inRadians(const std::vector<double>& angles);

}  // namespace gonio::io
