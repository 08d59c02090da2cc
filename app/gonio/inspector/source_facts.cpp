// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/inspector/source_facts.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

#include "app/gonio/comparison/comparison_numbers.h"
#include "core/materials/bundled_library.h"
#include "widgets/inputs/number_field.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {

struct SourceFactsText {
  Q_DECLARE_TR_FUNCTIONS(SourceFacts)
};
QString number(double value) { return QString::number(value, 'g', 3); }
QString percent(double fraction) { return QStringLiteral("%1 %").arg(QString::number(100 * fraction, 'f', 1)); }

QString gridText(const std::vector<int>& grid) {
  QStringList sizes;
  for (const int size : grid) sizes << QString::number(size);
  return sizes.join(QStringLiteral(" × "));
}

QString rangeText(const std::array<ChannelRange, 3>& channels) {
  QStringList lines;
  const QString names[] = {SourceFactsText::tr("R"), SourceFactsText::tr("G"), SourceFactsText::tr("B")};
  for (std::size_t c = 0; c < 3; ++c)
    lines << SourceFactsText::tr("%1  %2 to %3").arg(names[c], number(channels[c].min), number(channels[c].max));
  return lines.join('\n');
}

QString snrText(double snr) { return std::isfinite(snr) ? QString::number(snr, 'f', 1) : comparisonValue(snr); }

QString sourceText(const LoadedMaterial& loaded) {
  if (loaded.blend) return SourceFactsText::tr("the blend of the materials in their native forms");
  return loaded.material.source.format == materials::sgdFormat ? SourceFactsText::tr("the fit")
                                                               : SourceFactsText::tr("the file");
}

QString errorText(const LoadedMaterial& loaded, std::optional<double> snr, bool measuring) {
  return snr         ? SourceFactsText::tr("rendered SNR %1 dB against %2").arg(snrText(*snr), sourceText(loaded))
         : measuring ? SourceFactsText::tr("measuring the rendered SNR...")
                     : SourceFactsText::tr("rendered SNR not measured");
}

/// The table that is shown, or that stands for what is shown where a method needs one.
widgets::Fact tableFact(const LoadedMaterial& loaded, std::optional<double> snr, bool measuring) {
  const TabulatedBrdf* own = formOf<TabulatedBrdf>(*loaded.base);
  const bool isReciprocal = !loaded.material.brdf || loaded.material.brdf->isReciprocal();
  const HalfDifferenceGrid usual, grid = own ? own->grid() : isReciprocal ? usual : usual.wholeCircle();
  const QString size = gridText({grid.thetaHCount, grid.thetaDCount, grid.phiDCount});
  QString gridExplanation = SourceFactsText::tr("Half-difference grid: θh × θd × φd.");
  if (!grid.reciprocal)
    gridExplanation += ' ' + SourceFactsText::tr("φd covers the whole circle, since the material is not reciprocal.");
  const QString errorExplanation =
      SourceFactsText::tr(
          "Rendered SNR of the table against %1 in the comparison scene (bundled scene \"sphere\");\n"
          "30 dB is a root mean square error of about 3 %.")
          .arg(sourceText(loaded));
  if (!own)
    return {SourceFactsText::tr("Sampled table"),
            SourceFactsText::tr("%1\n%2").arg(size, errorText(loaded, snr, measuring)),
            SourceFactsText::tr("Factors and codes use a table sampled from %1, and so do fits if the material is "
                                "isotropic. The preview and the edits use the material itself, and so do fits if the "
                                "material is anisotropic.")
                    .arg(sourceText(loaded)) +
                '\n' + gridExplanation + '\n' + errorExplanation};
  widgets::Fact fact{
      SourceFactsText::tr("Table"),
      SourceFactsText::tr("%1, %2 MB").arg(size).arg(double(own->bytes()) * 1e-6, 0, 'f', 1),
      SourceFactsText::tr("Table that is shown and edited, with its size in memory.") + ' ' + gridExplanation};
  if (!loaded.isSampled()) {
    fact.toolTip += '\n' + SourceFactsText::tr("The material itself is this table; it was not resampled.");
    return fact;
  }
  fact.value += '\n' + errorText(loaded, snr, measuring);
  fact.toolTip += '\n' + SourceFactsText::tr("It was sampled from %1, which is not a table.").arg(sourceText(loaded)) +
                  ' ' + errorExplanation;
  return fact;
}

}  // namespace

std::vector<widgets::Fact> sourceFacts(const LoadedMaterial& loaded, std::optional<double> tableSnr, bool measuring) {
  const materials::MaterialSource& source = loaded.material.source;
  const QString path = QString::fromStdString(source.path.string()), hash = QString::fromStdString(source.sha256);
  std::vector<widgets::Fact> facts;
  const QString description = QString::fromStdString(source.description);
  facts.push_back({SourceFactsText::tr("Material"),
                   description.isEmpty() ? QString::fromStdString(loaded.material.name) : description});
  if (!path.isEmpty() && !path.startsWith(QStringLiteral("library:")))
    facts.push_back({SourceFactsText::tr("File"), path.section('/', -1), path});
  facts.push_back({SourceFactsText::tr("Format"), QString::fromStdString(source.format)});
  if (!source.grid.empty()) facts.push_back({SourceFactsText::tr("Data"), gridText(source.grid)});
  if (!loaded.isTable())
    facts.push_back(
        {SourceFactsText::tr("Shown as"), SourceFactsText::tr("native form, without a table"),
         SourceFactsText::tr(
             "The stored measurement, model or factors are evaluated and edited directly, not resampled to a table.")});
  else if (loaded.isSampled() && !loaded.material.brdf->isIsotropic())
    facts.push_back({SourceFactsText::tr("Shown as"), SourceFactsText::tr("mean over the azimuths of the light"),
                     SourceFactsText::tr("The preview cannot evaluate this anisotropic format. The editor shows, edits "
                                         "and exports a table without the anisotropy; goniotool and Python use the "
                                         "material itself.")});
  facts.push_back(tableFact(loaded, tableSnr, measuring));
  facts.push_back({SourceFactsText::tr("BRDF values [1/sr]"), rangeText(loaded.statistics.channels)});
  if (loaded.isTable())
    facts.push_back({SourceFactsText::tr("Invalid cells"), percent(loaded.statistics.invalidFraction),
                     SourceFactsText::tr("Cells below the horizon or not measured")});
  QStringList angles, albedo;
  for (std::size_t i = 0; i < loaded.albedo.size(); ++i) {
    angles << SourceFactsText::tr("%1°").arg(LoadedMaterial::albedoDegrees[i]);
    albedo << number(luminance(loaded.albedo[i]));
  }
  facts.push_back({SourceFactsText::tr("Albedo"),
                   SourceFactsText::tr("%1 at %2").arg(albedo.join(", "), angles.join(", ")),
                   SourceFactsText::tr("Directional albedo (luminance): fraction of uniform light that is reflected "
                                       "towards the viewer, by polar angle of the viewer")});
  for (const std::string& note : source.notes)
    facts.push_back({SourceFactsText::tr("Note"), QString::fromStdString(note)});
  facts.push_back({SourceFactsText::tr("SHA-256"), hash.left(16) + QStringLiteral("…"), hash});
  return facts;
}

namespace {

QString timesOf(const QString& what, const std::optional<study::UseCost>& cost) {
  return SourceFactsText::tr("%1: %2").arg(what, cost ? widgets::timesText(*cost) : SourceFactsText::tr("measuring"));
}

}  // namespace

QString costLine(const CostMonitor::Costs& costs) {
  QStringList parts;
  if (costs.fitBytes > 0)
    parts << SourceFactsText::tr("Match: %1")
                 .arg(costs.fitSnr ? matchWord(*costs.fitSnr) : SourceFactsText::tr("measuring"));
  parts << (costs.edited
                ? SourceFactsText::tr("%1 a frame").arg(widgets::secondsText(1e-3 * costs.edited->frameMilliseconds))
                : SourceFactsText::tr("measuring a frame"));
  if (costs.fitBytes > 0) parts << QLocale().formattedDataSize(qint64(costs.fitBytes), 1, QLocale::DataSizeSIFormat);
  QString line = parts.join(QStringLiteral("; "));
  line[0] = line[0].toUpper();
  return line;
}

QString costDetails(const CostMonitor::Costs& costs, const fitting::FitResult* fit) {
  QStringList lines;
  if (costs.fitBytes > 0)
    lines << SourceFactsText::tr(
        "Match: how closely the model behind the sliders resembles the measurement. The image "
        "shows the measurement itself; the model computes only what an edit changes.");
  // A line that came and went would move the rows below it under the hand.
  if (costs.fitBytes > 0)
    lines << SourceFactsText::tr("Rendered SNR of the fit: %1")
                 .arg(costs.fitSnr ? SourceFactsText::tr("%1 dB").arg(snrText(*costs.fitSnr))
                                   : SourceFactsText::tr("measuring"));
  if (fit) {
    for (const std::string& warning : fit->warnings) lines << QString::fromStdString(warning);
    const auto metrics = metrics::allBrdfMetrics();
    for (std::size_t i = 0; i < fit->errors.size(); ++i) {
      const std::string_view name = metrics::metricId(metrics[i]);
      lines << SourceFactsText::tr("%1 error of the fit: %2")
                   .arg(QString::fromUtf8(name.data(), qsizetype(name.size())), number(fit->errors[i]));
    }
    lines << SourceFactsText::tr("Fitted in %1 s to %2 cells")
                 .arg(number(fit->seconds), QLocale().toString(qulonglong(fit->usedCells)));
  }
  if (costs.fitBytes > 0) lines << SourceFactsText::tr("Parameters of the fit: %1 bytes").arg(costs.fitBytes);
  lines << timesOf(SourceFactsText::tr("Measured"), costs.measured)
        << timesOf(SourceFactsText::tr("With edits"), costs.edited)
        << SourceFactsText::tr(
               "Times on this machine: one evaluation on one core; one frame of the path tracer on all cores (sphere, "
               "128 × 128 pixels, 32 samples per pixel)");
  return lines.join('\n');
}

}  // namespace gonio::app
