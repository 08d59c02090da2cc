// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <limits>
#include <memory>
#include <vector>

#include "core/rendering/render_picture.h"
#include "core/study/accuracy_study.h"
#include "core/support/task_control.h"
#include "widgets/preview/gl/preview_subject.h"

namespace gonio::app {

/// The prepared reference of a comparison: its BRDF and its picture. Made once and used for all steps of an edit.
struct ComparisonReference {
  widgets::PreviewSubject subject;
  std::shared_ptr<const Brdf> brdf;
  std::unique_ptr<const rendering::RenderedComparison> picture;
};
using ComparisonReferencePtr = std::shared_ptr<const ComparisonReference>;

/// Prepares a reference, in about a second. @throws Cancelled.
ComparisonReferencePtr comparisonReference(const widgets::PreviewSubject& subject, const TaskControl& control = {});

struct ComparisonNumbers {
  std::vector<double> errors;  ///< in the order of metrics::allBrdfMetrics()
  double brdfSnr = 0;          ///< dB
  double renderedSnr = 0;      ///< dB, in comparisonScene()
  double renderedPsnr = 0;     ///< dB
};
/// Compares a subject with the reference, in about a second. @throws Cancelled.
ComparisonNumbers compareSubjects(const widgets::PreviewSubject& test, const ComparisonReference& reference,
                                  const TaskControl& control = {});

/// One line of a table of the numbers.
struct ComparisonLine {
  QString name, unit, meaning;
  double value;
  QString formulaHtml = {};  ///< of a metric, with its source
};
/// All numbers with their names; the values are NaN if `numbers` is null.
std::vector<ComparisonLine> comparisonLines(const ComparisonNumbers* numbers);
/// How close two materials look, in a word: "indistinguishable" from 40 dB of rendered SNR if FLIP is at most 0.02,
/// "close" from 30 dB, "approximate" below; "exact" for an infinite SNR. @param flip NaN: not measured.
QString matchWord(double renderedSnr, double flip = std::numeric_limits<double>::quiet_NaN());
/// Text of a value: "23.4", "∞" for equal pictures, "undefined" for NaN.
QString comparisonValue(double value);
/// Comma-separated text: subjects and scene in comment lines, then one line with quantity, value and unit per number.
QString comparisonCsv(const ComparisonNumbers& numbers, const QString& test, const QString& reference);

}  // namespace gonio::app
