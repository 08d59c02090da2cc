// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "core/study/accuracy_study.h"

namespace gonio::figures {

/// Whether higher or lower values are better.
enum class Better { higher, lower };

/// A number to display below a picture: an error, size or time of a representation.
struct FigureNumber {
  std::string id;    ///< in descriptions and JSON, e.g. "rendered-snr", "flip", "log", "bytes", "evaluation-time"
  std::string name;  ///< for display in figures and tables, e.g. "SNR"
  std::string unit;  ///< of the value; empty for a number without unit
  Better better = Better::lower;
  bool isError = true;   ///< an error or SNR, not a cost
  bool isTimed = false;  ///< a time on this machine, which differs from run to run
  std::function<double(const study::MeasuredRepresentation& studied, const Image& reference)> value;

  /// Name and unit, e.g. "SNR [dB]".
  std::string title() const;
};

/// All numbers: rendered SNR; metrics of pictures (metrics::imageMetricRecords()); metrics of BRDF values
/// (metrics::metricRecords()); size; times of encoding, of one evaluation and of one frame.
std::span<const FigureNumber> figureNumbers();
/// @throws Error that lists the ids.
const FigureNumber& figureNumber(std::string_view id);

/// A value with three significant digits and its unit, for sizes and times with an SI prefix: "38.2 dB", "44.7 kB",
/// "1.25 ms", "∞ dB"; "-" for NaN.
std::string valueText(const FigureNumber& number, double value);
/// The value with three significant digits, without SI prefix and unit, for tables with the unit in the header: "38.2",
/// "1.25e-08". Bytes and values from 1000 on are whole numbers.
std::string tableText(const FigureNumber& number, double value);

}  // namespace gonio::figures
