// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <algorithm>
#include <array>

#include "core/baselines/baselines.h"
#include "core/formats/pdv.h"
#include "core/metrics/brdf_metrics.h"
#include "core/models/registry.h"
#include "core/study/accuracy_study.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace baseline_representations_test {
using namespace gonio;
using namespace gonio::study;

constexpr HalfDifferenceGrid smallGrid{.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 36};

std::shared_ptr<const TabulatedBrdf> plastic() {
  static const auto table = bakeTable(*test::ggx(Rgb(0.05, 0.2, 0.3), Rgb(0.9, 0.5, 0.2), 0.2, 0.04), smallGrid);
  return table;
}

std::vector<Representation> baselineRows(std::vector<int> terms, std::vector<std::string> names = {"baselines"}) {
  return representationsOf({.names = std::move(names), .terms = std::move(terms)});
}

/// All except the non-parametric factors, which are a family of their own.
std::vector<const baselines::Baseline*> studiedBaselines() {
  std::vector<const baselines::Baseline*> studied;
  for (const RepresentationKind& kind : representationKinds())
    if (kind.baseline) studied.push_back(kind.baseline);
  return studied;
}

/// Baselines as representations of the study.
class BaselineRepresentationsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The budgets are the bytes of PDV factors; no model is listed twice.
  void budgetsAreTheBytesOfPdvFactors() {
    for (const auto form : {factorization::PdvForm::twoFactors, factorization::PdvForm::threeFactors}) {
      const auto factors = factorization::factorizePdv(*plastic(), {.form = form, .terms = 2}).factors;
      QCOMPARE(formats::pdvFileBytes(form, 2), formats::pdvFileBytes(factors));
    }
    const auto rows = baselineRows({2, 10, 20});
    for (const baselines::Baseline* baseline : studiedBaselines()) {
      std::vector<double> budgets;
      for (const Representation& row : rows)
        if (row.kind->id == baseline->id) budgets.push_back(row.budget);
      if (baseline->maxBytes == 0)
        QVERIFY(budgets == std::vector<double>{0});
      else if (baseline->id == "cp" || baseline->id == "gaussian-process")
        // The largest models, 64 terms and 512 nodes, are smaller than ten terms of PDV.
        QVERIFY(budgets == (std::vector<double>{10'120, 44'680}));
      else
        QVERIFY(budgets == (std::vector<double>{10'120, 44'680, 87'880}));
    }
    QCOMPARE(studiedBaselines().size(), baselines::allBaselines().size() - 1);
    QVERIFY(std::ranges::none_of(rows, [](const Representation& row) { return row.kind->id == "nonparametric"; }));
    RepresentationChoice choice{.names = {"baselines"}};
    const std::vector<std::string> wrong{"nonparametric"};
    QVERIFY_EXCEPTION_THROWN(choice.restrict("baselines", wrong), Error);
    for (const Representation& row : rows)
      QVERIFY(std::ranges::none_of(models::allModels(), [&](const auto* m) { return m->spec().id == row.kind->id; }));
  }

  void onlyThoseThatAreChosen() {
    RepresentationChoice choice{.names = {"table", "baselines"}, .terms = {1, 2}};
    const std::vector<std::string> chosen{"bilgili", "mccool"};
    choice.restrict("baselines", chosen);
    choice.restrict("fits", std::vector<std::string>{"ggx"});  // no fits are selected
    const auto rows = representationsOf(choice);
    QCOMPARE(rows.size(), std::size_t(5));
    QCOMPARE(rows[2].fullLabel(), std::string("McCool et al. 2001"));  // in the order of the table
    QCOMPARE(rows[4].fullLabel(), std::string("Bilgili et al. 2011, up to 10120 bytes"));
    QVERIFY(std::ranges::count(RepresentationChoice().names, "baselines") == 0);
  }

  /// The records equal the results of separate calls of the library for each budget.
  void recordsAreThoseOfTheLibrary_data() {
    QTest::addColumn<QString>("id");
    for (const baselines::Baseline* baseline : studiedBaselines())
      QTest::newRow(baseline->id.data()) << QString(baseline->id.data());
  }
  void recordsAreThoseOfTheLibrary() {
    QFETCH(QString, id);
    const baselines::Baseline& baseline = baselines::findBaseline(id.toStdString());
    const auto rows = baselineRows({1, 3}, {id.toStdString()});
    StudyOptions options;
    options.picture = {.width = 16, .height = 16, .samples = 4};
    options.timed = false;
    const auto records = runStudy({plastic(), plastic()}, rows, options);
    QCOMPARE(records.size(), rows.size());
    const auto log = std::size_t(metrics::BrdfMetric::log);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::array<std::size_t, 1> budget{std::size_t(rows[i].budget)};
      const baselines::ComparedModel model = baseline.build(*plastic(), budget, {}).front();
      QCOMPARE(records[i].bytes, model.bytes);
      QVERIFY(rows[i].budget == 0 || double(model.bytes) <= rows[i].budget);
      QVERIFY(records[i].errors == metrics::brdfErrors(*plastic(), *model.brdf));
      QVERIFY(records[i].encodeSeconds > 0 && records[i].renderedSnr > 5);
      if (i > 0) {
        QVERIFY(records[i].bytes > records[i - 1].bytes);
        QVERIFY2(records[i].errors[log] <= 1.01 * records[i - 1].errors[log],
                 qPrintable(QString("%1 %2").arg(records[i].errors[log]).arg(records[i - 1].errors[log])));
      }
    }
  }
};

GONIO_TEST(BaselineRepresentationsTest)
}  // namespace baseline_representations_test

#include "baseline_representations_test.moc"
