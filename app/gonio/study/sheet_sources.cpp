// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/sheet_sources.h"

#include <QCoreApplication>
#include <QLocale>

#include "app/gonio/comparison/comparison_numbers.h"
#include "app/gonio/study/fit_ranking_model.h"
#include "app/gonio/study/study_model.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {

QString sheetText(const char* text) { return QCoreApplication::translate("ContactSheet", text); }

SheetEntry fitEntry(const LoadedMaterial& material, const study::RankedFit& ranked) {
  const fitting::FitResult& fit = ranked.fit;
  const TabulatedBrdf* table = formOf<TabulatedBrdf>(*material.base);
  const widgets::PreviewSubject subject{
      widgets::StandaloneModel{fit.model, fit.parameters, table ? table->grid() : HalfDifferenceGrid()},
      material.density};
  return {.name = widgets::toQString(fit.model->spec().name),
          .numbers = sheetText("Rendered SNR %1 dB, %2 parameters")
                         .arg(comparisonValue(ranked.renderedSnr))
                         .arg(ranked.parameterCount),
          .snr = ranked.renderedSnr,
          .brdf = fit.model->instantiate(fit.parameters),
          .subject = [subject](const TaskControl&) { return subject; }};
}

SheetEntry studyEntry(const StudyModel::Studied& studied) {
  const study::StudyRecord& record = studied->record;
  return {.name = QString::fromStdString(record.representation.fullLabel()),
          .numbers = sheetText("Rendered SNR %1 dB, %2, %3 per frame")
                         .arg(comparisonValue(record.renderedSnr),
                              QLocale().formattedDataSize(qint64(record.bytes), 1, QLocale::DataSizeSIFormat),
                              QString::fromStdString(study::shortQuantity(1e-3 * record.frameMilliseconds, "s"))),
          .snr = record.renderedSnr,
          .brdf = studied->brdf,
          .subject = [studied](const TaskControl& control) { return studiedSubject(*studied, control); }};
}

}  // namespace

widgets::PreviewSubject studiedSubject(const study::MeasuredRepresentation& studied, const TaskControl& control) {
  const auto table = studied.tabulated(control);
  return widgets::measuredSubject(table, std::make_shared<const TabulatedDensity>(*table));
}

SheetSource sheetSource(const QString& name, const LoadedMaterialPtr& material, const FitRankingModel& ranking) {
  SheetSource source{name, material, {}};
  for (int row = 0; row < ranking.rowCount(); ++row) source.entries.push_back(fitEntry(*material, ranking.ranked(row)));
  return source;
}

SheetSource sheetSource(const QString& name, const LoadedMaterialPtr& material, const StudyModel& study) {
  SheetSource source{name, material, {}};
  for (const int row : study.measuredRows()) source.entries.push_back(studyEntry(study.studied(row)));
  return source;
}

}  // namespace gonio::app
