// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/io/csv_text.h"
#include "core/study/representation.h"
#include "core/support/task_control.h"

/// What a study measures and writes down: records, their summary over several materials, the machine, tables.
namespace gonio::study {

/// Nanoseconds per pair, over several runs of the same batch.
struct EvaluationTime {
  double median = 0, lowerQuartile = 0, upperQuartile = 0;
};

/// Measures how much processor time an evaluation takes on this machine at the moment: one thread evaluates a batch of
/// 16,384 pairs of directions, uniform over the hemisphere, seven times, or at least three times if that takes more
/// than half a second. Takes a few ms for most BRDFs. @throws Cancelled.
EvaluationTime measureEvaluation(const Brdf& brdf, const TaskControl& control = {});

/// A quantile, linear between the values; NaN for no values. @param fraction in [0, 1]; 0.5 is the median.
double quantile(std::vector<double> values, double fraction);

/// Measured cost and accuracy of a representation of a material.
struct StudyRecord {
  Representation representation;
  /// Size of its file in bytes. For a table: size of its values and two flags per cell in memory. For a fit: size of
  /// its parameters as float32. Excludes data shared by all materials (dictionary, components).
  std::size_t bytes = 0;
  double encodeSeconds = 0;      ///< time to build the representation from the table; 0 for the table itself, NaN if
                                 ///< it was not made here, as for the published non-parametric factors
  EvaluationTime evaluation;     ///< ns per pair on one thread, in batches; NaN if not measured
  double frameMilliseconds = 0;  ///< median time of a frame of comparisonScene() by the path tracer with all threads;
                                 ///< NaN if not measured
  std::vector<double> errors;    ///< against the measurement, in the order of metrics::allBrdfMetrics()
  double renderedSnr = 0;        ///< in comparisonScene(), dB; +infinity for equal pictures, NaN for a black reference
};

/// The horizontal axis of a study.
enum class Cost { evaluation, frame, bytes, encoding };
inline constexpr Cost allCosts[] = {Cost::evaluation, Cost::frame, Cost::bytes, Cost::encoding};

double costOf(const StudyRecord& record, Cost cost);
/// The name for display: "evaluation", "frame", "size", "encoding".
std::string_view costName(Cost cost);
/// The unit of costOf(): "ns", "ms", "B" or "s".
std::string_view costUnit(Cost cost);

/// Machine, program and date of measured times.
struct MachineFacts {
  std::string processor;  ///< name, or "unknown processor" if the system does not report it
  int cores = 0;          ///< of the machine, as reported by the system
  int threads = 0;        ///< of parallel loops
  std::string version;    ///< of Gonio
  std::string compiler;   ///< e.g. "GNU 12.2.0"
  std::string flags;      ///< build type and flags of the compiler
  std::string date;       ///< ISO 8601, UTC, e.g. "2026-11-21T22:15:00Z"
};

/// The facts of this process now; `threads` is threadCount() of the calling thread.
MachineFacts machineFacts();

/// Only the facts of the program, for results without times: no processor and no date.
MachineFacts buildFacts();

/// Lines for display: processor with its cores and threads; program and build; date. Empty facts are omitted.
std::vector<std::string> machineLines(const MachineFacts& facts);

/// One representation at one budget over several materials.
struct StudySummary {
  StudyRecord median;             ///< medians over the materials, without NaN
  std::size_t materials = 0;      ///< number of materials with this representation
  double minSnr = 0, maxSnr = 0;  ///< minimum and maximum over the materials, dB; NaN if all are NaN
  std::size_t worst = 0;          ///< the first material with the minimum SNR
};

/// Summarises records of several materials, ordered by family and, within a family, as they first appear. `worst` is an
/// index into `materials`.
std::vector<StudySummary> summarise(std::span<const std::vector<StudyRecord>> materials);

/// A table with one row per record: family, id, label, budget, bytes, times, rendered SNR, every metric. Comments
/// contain `title`, scene and size of the pictures, machine, build and date. An infinite SNR is "inf", an undefined one
/// an empty field.
io::CsvTable studyCsv(const std::string& title, std::span<const StudyRecord> records, const MachineFacts& machine,
                      const std::string& pictures);

/// The same for medians over several materials, with the number of materials, the minimum and maximum rendered SNR, and
/// the material of the minimum. @param materials names of the summarised materials, in order.
io::CsvTable summaryCsv(const std::string& title, std::span<const StudySummary> summaries,
                        std::span<const std::string> materials, const MachineFacts& machine,
                        const std::string& pictures);

/// A description of the pictures of a study, e.g. "sphere-studio, 128 x 128, 32 samples".
std::string picturesText(int width, int height, int samples);

}  // namespace gonio::study
