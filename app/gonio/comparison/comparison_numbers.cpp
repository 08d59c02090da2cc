// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/comparison/comparison_numbers.h"

#include <QCoreApplication>
#include <cmath>
#include <limits>

#include "core/io/csv_text.h"
#include "core/metrics/brdf_metrics.h"
#include "widgets/parameters/formula_text.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {

struct ComparisonNumbersText {
  Q_DECLARE_TR_FUNCTIONS(ComparisonNumbers)
};

}  // namespace

ComparisonReferencePtr comparisonReference(const widgets::PreviewSubject& subject, const TaskControl& control) {
  auto reference = std::make_shared<ComparisonReference>();
  reference->subject = subject;
  reference->brdf = widgets::subjectBrdf(subject);
  reference->picture = std::make_unique<const rendering::RenderedComparison>(
      *reference->brdf, rendering::smallComparisonPicture(), TaskControl{control.stop, {}});
  return reference;
}

ComparisonNumbers compareSubjects(const widgets::PreviewSubject& test, const ComparisonReference& reference,
                                  const TaskControl& control) {
  const auto brdf = widgets::subjectBrdf(test);
  const rendering::ComparisonPicture picture = reference.picture->render(*brdf, {control.stop, {}});
  control.throwIfStopped();
  ComparisonNumbers numbers;
  numbers.renderedSnr = reference.picture->signalToNoiseRatio(picture);
  numbers.renderedPsnr = reference.picture->peakSignalToNoiseRatio(picture);
  numbers.errors = metrics::brdfErrors(*reference.brdf, *brdf);
  control.throwIfStopped();
  numbers.brdfSnr = metrics::brdfSignalToNoiseRatio(*reference.brdf, *brdf);
  return numbers;
}

std::vector<ComparisonLine> comparisonLines(const ComparisonNumbers* numbers) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const QString scene = ComparisonNumbersText::tr(
      "Computed from images of both materials in the comparison scene (bundled scene \"sphere\")");
  std::vector<ComparisonLine> lines{
      {ComparisonNumbersText::tr("Rendered SNR"), ComparisonNumbersText::tr("dB"), scene,
       numbers ? numbers->renderedSnr : none},
      {ComparisonNumbersText::tr("Rendered PSNR"), ComparisonNumbersText::tr("dB"), scene,
       numbers ? numbers->renderedPsnr : none},
      {ComparisonNumbersText::tr("BRDF SNR"), ComparisonNumbersText::tr("dB"),
       ComparisonNumbersText::tr(
           "SNR of BRDF values times both cosines, over all directions at which both materials have data"),
       numbers ? numbers->brdfSnr : none}};
  const auto records = metrics::metricRecords();
  for (std::size_t i = 0; i < records.size(); ++i) {
    const metrics::MetricRecord& record = records[i];
    lines.push_back({widgets::toQString(record.name), widgets::toQString(record.unit),
                     widgets::toQString(record.formula), numbers ? numbers->errors[i] : none,
                     widgets::metricToolTip(record.formula, record.reference)});
  }
  return lines;
}

QString matchWord(double renderedSnr, double flip) {
  constexpr double indistinguishable = 40, close = 30, visible = 0.02;
  if (std::isinf(renderedSnr) && renderedSnr > 0) return ComparisonNumbersText::tr("exact");
  if (renderedSnr >= indistinguishable && !(flip > visible)) return ComparisonNumbersText::tr("indistinguishable");
  return renderedSnr >= close ? ComparisonNumbersText::tr("close") : ComparisonNumbersText::tr("approximate");
}

QString comparisonValue(double value) {
  if (std::isnan(value)) return ComparisonNumbersText::tr("undefined");
  if (std::isinf(value)) return QStringLiteral("∞");
  return QString::number(value, 'g', 4);
}

QString comparisonCsv(const ComparisonNumbers& numbers, const QString& test, const QString& reference) {
  const QString compared =
      ComparisonNumbersText::tr("%1 against %2, scene %3").arg(test, reference, rendering::comparisonSceneName);
  io::CsvTable table{.comments = {compared.toStdString()}, .columns = {{"quantity", {}}, {"value", {}}, {"unit", {}}}};
  for (const ComparisonLine& line : comparisonLines(&numbers)) {
    table.columns[0].texts.push_back(line.name.toStdString());
    table.columns[1].values.push_back(line.value);
    table.columns[2].texts.push_back(line.unit.toStdString());
  }
  return QString::fromStdString(io::toCsv(table));
}

}  // namespace gonio::app
