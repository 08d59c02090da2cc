// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "core/rendering/rendered_comparison.h"
#include "core/support/task_control.h"
#include "widgets/preview/gl/preview_subject.h"

namespace gonio::app {

/// What a subject is compared with, ready for use: its table and its picture. Made once, used for every step of an
/// edit.
struct ComparisonReference {
  widgets::PreviewSubject subject;
  std::shared_ptr<const TabulatedBrdf> table;
  std::unique_ptr<const RenderedComparison> picture;
};
using ComparisonReferencePtr = std::shared_ptr<const ComparisonReference>;

/// A subject that is no table is sampled as one first. About a second. @throws Cancelled.
ComparisonReferencePtr comparisonReference(const widgets::PreviewSubject& subject, const TaskControl& control = {});

struct ComparisonNumbers {
  std::vector<double> errors;  ///< in the order of metrics::allBrdfMetrics()
  double brdfSnr = 0;          ///< dB
  double renderedSnr = 0;      ///< dB, in comparisonScene()
  double renderedPsnr = 0;     ///< dB
};
/// About a second. @throws Cancelled.
ComparisonNumbers compareSubjects(const widgets::PreviewSubject& test, const ComparisonReference& reference,
                                  const TaskControl& control = {});

/// One line of a table of the numbers.
struct ComparisonLine {
  QString name, unit, explanation;
  double value;
};
/// Every number, named; the values are NaN without numbers.
std::vector<ComparisonLine> comparisonLines(const ComparisonNumbers* numbers);
/// For people: "23.4", "∞" for equal pictures, "undefined" where there is no number.
QString comparisonValue(double value);
/// Comma-separated: what is compared in which scene in comment lines, then quantity, value and unit a line.
QString comparisonCsv(const ComparisonNumbers& numbers, const QString& test, const QString& reference);

}  // namespace gonio::app
