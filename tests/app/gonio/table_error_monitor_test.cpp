// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/inspector/monitors.h"

#include <QSignalSpy>
#include <QTest>

#include "app/gonio/comparison/comparison_numbers.h"
#include "app/gonio/document/edit_steps.h"
#include "app/gonio/inspector/source_facts.h"
#include "core/rendering/render_picture.h"
#include "tests/app/gonio/document_edits.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace table_error_monitor_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::app;

constexpr int patience = 60000;
const RenderOptions picture{.width = 32, .height = 32, .samples = 4, .density = {}};

/// A material in another form than a table; or, without one, its table.
LoadedMaterialPtr glossy(double roughness, bool sampled) {
  auto loaded = std::make_shared<LoadedMaterial>();
  loaded->material.name = "glossy";
  const std::shared_ptr<const Brdf> form = test::ggx(Rgb(0.2), Rgb(0.8), roughness, 0.5);
  loaded->base = bakeTable(*form, {12, 12, 12});
  loaded->material.brdf = sampled ? form : loaded->base;
  return loaded;
}

QString tableText(const LoadedMaterial& material, const TableErrorMonitor& monitor) {
  for (const widgets::Fact& fact : sourceFacts(material, monitor.snr(), !monitor.isSettled()))
    if (fact.name == "Table") return fact.value;
  return {};
}

class TableErrorMonitorTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void measuresWhatSamplingCosts() {
    Document document;
    BackgroundTasks tasks;
    const TableErrorMonitor monitor(document, tasks, nullptr, picture);
    QSignalSpy measured(&monitor, &TableErrorMonitor::measured);
    const LoadedMaterialPtr material = glossy(0.3, true);
    document.setMaterial(material);
    QVERIFY(!monitor.isSettled() && !monitor.snr());
    QVERIFY(tableText(*material, monitor).contains("measuring"));
    QVERIFY(measured.wait(patience));
    const RenderedComparison comparison(*material->material.brdf, picture);
    QCOMPARE(*monitor.snr(), comparison.signalToNoiseRatio(comparison.render(*material->table())));
    QVERIFY(tableText(*material, monitor).contains(QString::number(*monitor.snr(), 'f', 1) + " dB against the file"));
    QVERIFY(monitor.isSettled());
  }

  void aTableItselfHasNoError() {
    Document document;
    BackgroundTasks tasks;
    const TableErrorMonitor monitor(document, tasks, nullptr, picture);
    const LoadedMaterialPtr material = glossy(0.3, false);
    document.setMaterial(material);
    QVERIFY(monitor.isSettled() && !monitor.snr() && tasks.isIdle());
    QVERIFY(!tableText(*material, monitor).contains("dB") && !tableText(*material, monitor).contains("measur"));
  }

  /// The number of one material is never shown for the next.
  void anotherMaterialStopsTheMeasurement() {
    Document document;
    BackgroundTasks tasks;
    const TableErrorMonitor monitor(document, tasks, nullptr, picture);
    QSignalSpy measured(&monitor, &TableErrorMonitor::measured);
    document.setMaterial(glossy(0.3, true));
    document.setMaterial(glossy(0.3, false));
    QVERIFY(monitor.isSettled() && tasks.isIdle());
    document.setMaterial(glossy(0.1, true));
    QVERIFY(measured.wait(patience));
    QCOMPARE(measured.count(), 1);
    document.setMaterial(glossy(0.2, true));
    QVERIFY(!monitor.snr() && !monitor.isSettled());
  }

  /// The line below the model: the rendered SNR of the fit as in a comparison, the times of the measurement and of the
  /// edited material. An edit outdates what it changes, and only that.
  void whatTheFitAndTheEditsCost() {
    Document document;
    BackgroundTasks tasks;
    const CostMonitor monitor(document, tasks);
    const LoadedMaterialPtr material = glossy(0.3, false);
    document.setMaterial(material);
    QTRY_VERIFY_WITH_TIMEOUT(monitor.costs().edited, patience);
    QVERIFY(!monitor.costs().fitSnr && monitor.costs().fitBytes == 0);
    QCOMPARE(monitor.costs().edited->frameMilliseconds, monitor.costs().measured->frameMilliseconds);
    QVERIFY(costLine(monitor.costs()).endsWith(" a frame"));
    test_support::adoptDefaultFit(document);
    QVERIFY(!monitor.costs().edited && monitor.costs().measured && monitor.costs().fitBytes > 0);
    QTRY_VERIFY_WITH_TIMEOUT(monitor.costs().edited, patience);
    const auto fit = defaultModel().instantiate(models::defaultParameters(defaultModel().spec()));
    const RenderedComparison comparison(*material->base, smallComparisonPicture());
    const double snr = comparison.signalToNoiseRatio(comparison.render(*fit));
    QCOMPARE(*monitor.costs().fitSnr, snr);
    // The word in the line, the number behind it.
    QVERIFY(costLine(monitor.costs()).startsWith("Match: " + matchWord(snr) + "; "));
    QVERIFY(costDetails(monitor.costs(), nullptr).contains(QString::number(snr, 'f', 1) + " dB"));
    setParameter(document, int(*defaultModel().spec().find("roughness")), Rgb(0.6));
    QVERIFY(!monitor.costs().edited && monitor.costs().fitSnr == snr);
    QTRY_VERIFY_WITH_TIMEOUT(monitor.costs().edited, patience);
    QVERIFY(costDetails(monitor.costs(), nullptr).contains("With edits: "));
    document.setMaterial(glossy(0.1, false));
    QVERIFY(!monitor.costs().measured && !monitor.costs().fitSnr);
  }
};

GONIO_TEST(TableErrorMonitorTest)
}  // namespace table_error_monitor_test

#include "table_error_monitor_test.moc"
