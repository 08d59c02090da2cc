// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "core/study/accuracy_study.h"

namespace gonio::figures {

/// Which of two values is the better one.
enum class Better { higher, lower };

/// A number that can stand under a picture: an error, a size or a time of a representation.
struct FigureNumber {
  std::string id;    ///< in descriptions and JSON: "rendered-snr", "flip", "log", "bytes", "evaluation-time"
  std::string name;  ///< for people, in figures and tables: "SNR"
  std::string unit;  ///< of the value; "" for a plain number
  Better better = Better::lower;
  bool isError = true;   ///< an error or a ratio to it, not a cost
  bool isTimed = false;  ///< measured on this machine now: another run gives another value
  std::function<double(const study::StudiedRepresentation& studied, const Image& reference)> value;

  /// "SNR [dB]".
  std::string title() const;
};

/// All of them: rendered SNR; metrics of the pictures (metrics::imageMetricRecords()); metrics of BRDF values
/// (metrics::metricRecords()); the size; the times of encoding, of an evaluation and of a frame.
std::span<const FigureNumber> figureNumbers();
/// @throws Error that lists the ids.
const FigureNumber& figureNumber(std::string_view id);

/// A value with three significant digits and its unit, bytes and times with the prefix of a thousand: "38.2 dB",
/// "44.7 kB", "1.25 ms", "∞ dB"; "-" where it is not a number.
std::string valueText(const FigureNumber& number, double value);
/// The same without prefix and unit, for tables with the unit in the head: "38.2", "1.25e-08"; whole numbers of bytes
/// and from 1000 on.
std::string plainText(const FigureNumber& number, double value);

}  // namespace gonio::figures
