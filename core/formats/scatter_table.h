// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/brdf/incidence_table_brdf.h"
#include "core/io/text_lines.h"
#include "core/materials/material.h"

/// Common parts of the text formats of optical design programs (Zemax, LightTools): a header of keys with lists of
/// angles in degrees, then blocks of values with one row per azimuth and one column per radial angle.
namespace gonio::formats {

/// Reads the words of a text in sequence, across lines; comments (from # to the end of a line) are ignored. Numbers are
/// in the notation of the text (io::notationOf()).
class WordReader {
 public:
  /// @param text must outlive the reader. @throws Error if the notation of its numbers is ambiguous.
  explicit WordReader(std::string_view text) : lines_(text), notation_(io::notationOf(text).unambiguous()) {}

  const io::NumberNotation& notation() const { return notation_; }

  /// The next word; empty at the end of the text.
  std::string_view next();
  /// The next word. @throws Error that names the line and `what` at the end of the text.
  std::string_view word(const char* what);
  /// The next word as a number. @throws Error that names the line if it is not a finite number.
  double number(const char* what);
  /// The next word as a count >= 1, at most the number of values that the rest of the text can contain. @throws as
  /// number().
  std::size_t count(const char* what);
  /// The next `numbers` words as numbers. Checks first that the rest of the text can contain so many. @throws as
  /// number().
  std::vector<double> numbers(std::size_t numbers, const char* what);
  /// Skips the rest of the line.
  void skipLine() { words_.clear(); }

  /// @throws Error "line 7: found 'word', expected ...".
  [[noreturn]] void fail(std::string_view word, const std::string& expected) const;

 private:
  io::TextLines lines_;
  io::NumberNotation notation_;
  std::vector<std::string_view> words_;  ///< of the line, the next one last
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

/// Sums of the values of a file for one direction of incidence, over repeated measurements and wavelengths.
struct ScatterBlock {
  std::array<std::vector<double>, 3> sums;  ///< per channel: monochrome in the first, or X, Y, Z; empty: no values
  std::array<int, 3> counts{};

  void add(std::size_t channel, std::span<const double> values);
  /// All values of another block.
  void add(const ScatterBlock& other);
  /// Means as linear sRGB, in the order of the values. @throws Error if a channel has no values.
  std::vector<glm::vec3> colours(const ScatterHeader& header) const;
};

/// Whether `key` is the first word of any line of the text.
bool hasKey(std::string_view text, std::string_view key);

/// Angles given in degrees, in rad.
std::vector<double> inRadians(const std::vector<double>& angles);

/// Sets the BRDF of a material to a table, its grid, and notes of how the file was read and of values that were
/// negative.
void setIncidenceTable(IncidenceTable table, const ScatterHeader& header, const io::NumberNotation& notation,
                       materials::Material& material);

}  // namespace gonio::formats
