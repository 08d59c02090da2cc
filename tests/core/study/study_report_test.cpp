// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QDateTime>
#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "core/math/parallel.h"
#include "core/metrics/brdf_metric.h"
#include "core/models/registry.h"
#include "core/study/study_plot.h"
#include "core/study/study_record.h"
#include "tests/support/test_program.h"

namespace study_report_test {
using namespace gonio;
using namespace gonio::study;

constexpr double infinity = std::numeric_limits<double>::infinity();

StudyRecord record(const Representation& representation, double nanoseconds, double snr, std::size_t bytes) {
  return {.representation = representation,
          .bytes = bytes,
          .encodeSeconds = representation.kind->family->id == "table" ? 0.0 : 0.5,
          .evaluation = {nanoseconds, nanoseconds - 1, nanoseconds + 2},
          .frameMilliseconds = nanoseconds / 10,
          .errors = std::vector<double>(metrics::allBrdfMetrics().size(), std::exp(-snr)),
          .renderedSnr = snr};
}

std::vector<StudyRecord> someRecords() {
  const auto all = representationsOf({.names = {"table", "factors"}, .terms = {1, 10}});
  return {record(all[0], 20, 30, 20'412'000), record(all[1], 50, infinity, 20'412'000),
          record(all[2], 80, 25, 3000),       record(all[3], 90, std::nan(""), 30'000),
          record(all[4], 100, -3, 3000),      record(all[5], 120, 38, 45'000)};
}

const MachineFacts machine{.processor = "Abacus <10 & \"more\">",
                           .cores = 2,
                           .threads = 1,
                           .version = "1.0",
                           .compiler = "GNU 1",
                           .flags = "-O3",
                           .date = "2026-11-21T22:00:00Z"};

/// What is made of the records of a study: summaries, tables, plots.
class StudyReportTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void quantilesBetweenNumbers() {
    QCOMPARE(quantile({4, 1, 3, 2}, 0.5), 2.5);
    QCOMPARE(quantile({4, 1, 3, 2}, 0), 1.0);
    QCOMPARE(quantile({4, 1, 3, 2}, 1), 4.0);
    QCOMPARE(quantile({5}, 0.25), 5.0);
    QCOMPARE(quantile({infinity, infinity, 1}, 0.5), infinity);
    QCOMPARE(quantile({infinity, 1}, 0), 1.0);
    QVERIFY(std::isnan(quantile({}, 0.5)));
  }

  void summariesAreMediansOfEachRepresentation() {
    std::vector<std::vector<StudyRecord>> materials{someRecords(), someRecords(), someRecords()};
    materials[1][0].renderedSnr = 50, materials[2][0].renderedSnr = 10;
    materials[1][0].bytes = 7, materials[2][0].bytes = 5;
    materials[2][0].errors[3] = 9, materials[1][0].errors[3] = 8;
    materials[0][3].renderedSnr = 12;  // the others are undefined
    materials[2].pop_back();
    const std::vector<StudySummary> summary = summarise(materials);
    QCOMPARE(summary.size(), materials[0].size());
    QCOMPARE(summary[0].median.renderedSnr, 30.0);
    QCOMPARE(summary[0].minSnr, 10.0);
    QCOMPARE(summary[0].maxSnr, 50.0);
    QCOMPARE(summary[0].worst, std::size_t(2));
    QCOMPARE(summary[3].worst, std::size_t(0));
    QCOMPARE(summary[0].median.bytes, std::size_t(7));
    QCOMPARE(summary[0].median.errors[3], 8.0);
    QCOMPARE(summary[1].median.renderedSnr, infinity);
    QCOMPARE(summary[3].median.renderedSnr, 12.0);
    QCOMPARE(summary[5].materials, std::size_t(2));
    QCOMPARE(summary[5].median.evaluation.upperQuartile, 122.0);
    for (std::size_t i = 0; i < summary.size(); ++i)
      QVERIFY(summary[i].median.representation == materials[0][i].representation);
    QVERIFY(summarise({}).empty());
  }

  /// A representation that the first material lacks is at its place in the lists.
  void summariesHaveTheOrderOfFamilies() {
    const auto all = representationsOf({.names = {"table", "nonparametric", "published-nonparametric", "neural"}});
    const auto recordsOf = [&](bool withPublished) {
      std::vector<StudyRecord> records;
      for (const Representation& one : all)
        if (withPublished || one.kind->id != "published-nonparametric") records.push_back(record(one, 10, 20, 3264));
      return records;
    };
    const auto summary = summarise(std::vector{recordsOf(false), recordsOf(true)});
    QCOMPARE(summary.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      QVERIFY(summary[i].median.representation == all[i]);
      QCOMPARE(summary[i].materials, std::size_t(i == 3 ? 1 : 2));
    }
  }

  void csvHasALineARecord() {
    const auto records = someRecords();
    const QString text = QString::fromStdString(toCsv(studyCsv("material: a", records, machine, "scene")));
    const QStringList lines = text.split('\n', Qt::SkipEmptyParts).filter(QRegularExpression("^[^#]"));
    QCOMPARE(lines.size(), qsizetype(records.size()) + 1);
    QVERIFY(text.startsWith("# material: a\n# images and frame times: scene\n# Abacus <10"));
    QVERIFY(text.contains("# 2026-11-21T22:00:00Z\n"));
    QVERIFY(lines[1].startsWith("table,table-cell,\"Table, cell look-up\",0,,20412000,0,20,19,22,2,30,"));
    QVERIFY(lines[2].contains(",inf,"));
    QVERIFY(lines[4].contains(",9,,"));  // an SNR that is no number
    QCOMPARE(lines[0].count(',') + 1, 12 + qsizetype(metrics::allBrdfMetrics().size()));
  }

  void axesHoldWhatNoScaleHolds() {
    const auto records = someRecords();
    const StudyAxis quality = qualityAxis(records, {});
    QVERIFY(quality.infiniteEnd && !quality.zeroEnd);
    QCOMPARE(quality.scale.min, -10.0);
    QCOMPARE(quality.scale.max, 40.0);
    QVERIFY(!quality.position(std::nan("")));
    QVERIFY(*quality.position(infinity) > *quality.position(40) && *quality.position(infinity) < 1);
    QVERIFY(*quality.position(-10) == 0 && *quality.position(0) > 0);
    const StudyAxis encoding = costAxis(records, Cost::encoding);
    QVERIFY(encoding.zeroEnd && encoding.scale.logarithmic);
    QVERIFY(*encoding.position(0) > 0 && *encoding.position(0) < *encoding.position(0.1));
    const StudyAxis size = costAxis(records, Cost::bytes);
    QVERIFY(!size.zeroEnd);
    QCOMPARE(*size.position(1e3), 0.0);
    QCOMPARE(*size.position(1e8), 1.0);
    for (const StudyAxis& axis : {quality, encoding, size})
      for (const StudyAxis::Tick& tick : axis.ticks()) QVERIFY(tick.position >= 0 && tick.position <= 1);
    QVERIFY(qualityAxis(records, metrics::BrdfMetric::log).scale.logarithmic);
    // Labels beside those of infinity and zero would overlap them.
    for (const StudyAxis::Tick& tick : quality.ticks()) QVERIFY(tick.text == "∞" || tick.position <= 0.9);
    for (const StudyAxis::Tick& tick : encoding.ticks()) QVERIFY(tick.text == "0" || tick.position >= 0.1);
  }

  void numbersAreShort() {
    const std::pair<double, const char*> cases[] = {{0, "0"},        {12, "12"},           {999.4, "999"},
                                                    {999.6, "1k"},   {20412000, "20.4M"},  {-1500, "-1.5k"},
                                                    {infinity, "∞"}, {0.0123456, "0.0123"}};
    for (const auto& [value, text] : cases) QCOMPARE(shortNumber(value), std::string(text));
    QCOMPARE(shortNumber(std::nan("")), std::string("-"));
    const std::tuple<double, const char*, const char*> quantities[] = {
        {44700, "B", "44.7 kB"}, {512, "B", "512 B"},    {1.28e-6, "s", "1.28 µs"}, {74.1e-9, "s", "74.1 ns"},
        {9.996e-4, "s", "1 ms"}, {5e-10, "s", "0.5 ns"}, {0, "s", "0 s"},           {infinity, "s", "∞ s"}};
    for (const auto& [value, unit, text] : quantities) QCOMPARE(shortQuantity(value, unit), std::string(text));
  }

  /// A marker with its numbers for each record that has some, in every panel; well-formed, whatever the names hold.
  void svgShowsEachRecord() {
    const auto records = someRecords();
    const auto panels = allCostAxes();
    QCOMPARE(panels.size(), std::size(allCosts));
    const std::string svg = studySvg("A <material> & \"more\"", records, panels, machineLines(machine));
    QXmlStreamReader reader(QString::fromStdString(svg));
    int titles = 0, fronts = 0;
    QStringList texts;
    while (!reader.atEnd()) {
      reader.readNext();
      if (reader.isStartElement() && reader.name() == u"title") ++titles;
      if (reader.isStartElement() && reader.name() == u"polyline")
        fronts += reader.attributes().hasAttribute("stroke-dasharray");
      if (reader.isCharacters() && !reader.isWhitespace()) texts << reader.text().toString();
    }
    QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
    QCOMPARE(titles, int(panels.size() * (records.size() - 1)));
    QCOMPARE(fronts, int(panels.size()));
    for (const char* text : {"A <material> & \"more\"", "evaluation [ns]", "frame [ms]", "size [B]", "encoding [s]",
                             "rendered SNR [dB]", "Table, cell look-up", "PDV factors, two curves", "10 terms", "∞"})
      QVERIFY2(texts.contains(text), text);
    QVERIFY(texts.contains("Abacus <10 & \"more\">, 2 cores, 1 thread"));
    // Nothing to show is no error.
    studySvg("", {}, panels, {});
    studySvg("", records, std::vector<StudyAxes>{{.quality = metrics::BrdfMetric::lab}}, {});
  }

  /// Without a time of encoding: a point in the other three panels, whose title states no such time.
  void svgOfAnUnknownTime() {
    StudyRecord one = record(representationsOf({.names = {"published-nonparametric"}})[0], 10, 20, 3264);
    one.encodeSeconds = std::nan("");
    const std::string svg = studySvg("", std::vector{one}, allCostAxes(), {});
    QCOMPARE(QString::fromStdString(svg).count("<title>Non-parametric factors, published: 20 dB"), 3);
    QVERIFY(svg.find("encoded in") == std::string::npos);
  }

  /// No two series differ in colour only.
  void seriesDifferByShape() {
    std::set<std::pair<plots::Marker, bool>> shapes;
    std::set<std::string_view> names;
    for (const RepresentationKind& kind : representationKinds()) {
      shapes.insert({kind.style.marker, kind.style.hollow});
      names.insert(kind.legendName());
    }
    QCOMPARE(shapes.size(), names.size());
  }

  void theMachineIsNamed() {
    const MachineFacts facts = machineFacts();
    QVERIFY(!facts.processor.empty() && facts.cores > 0 && facts.threads > 0 && facts.threads <= facts.cores);
    QVERIFY(!facts.version.empty() && !facts.compiler.empty() && !facts.flags.empty());
    QVERIFY(QDateTime::fromString(QString::fromStdString(facts.date), Qt::ISODate).isValid());
    QCOMPARE(machineLines(facts).size(), std::size_t(3));
    // Of the program alone: the same line, without processor and date.
    QVERIFY(machineLines(buildFacts()) == std::vector<std::string>{machineLines(facts)[1]});
    const ThreadLimit limit(1);
    QCOMPARE(machineFacts().threads, 1);
  }
};

GONIO_TEST(StudyReportTest)
}  // namespace study_report_test

#include "study_report_test.moc"
