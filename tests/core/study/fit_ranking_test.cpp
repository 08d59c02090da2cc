// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/accuracy_study.h"

#include <QTest>
#include <cmath>

#include "core/fitting/fit_parameters.h"
#include "core/math/parallel.h"
#include "core/rendering/render_picture.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace fit_ranking_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::fitting;
using namespace gonio::study;

constexpr HalfDifferenceGrid smallGrid{.thetaHCount = 45, .thetaDCount = 30, .phiDCount = 36};

std::shared_ptr<const TabulatedBrdf> plastic() {
  static const auto table = bakeTable(*test::ggx(Rgb(0.05, 0.2, 0.3), Rgb(0.9, 0.5, 0.2), 0.2, 0.04), smallGrid);
  return table;
}

RankingOptions fewModels() {
  RankingOptions options;
  for (const char* id : {"lambert", "ggx", "blinn-phong"}) options.models.push_back(&models::findModel(id));
  options.picture = {.width = 24, .height = 24, .samples = 4};
  return options;
}

class FitRankingTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void rowsHoldWhatTheirPartsGiveAlone() {
    const RankingOptions options = fewModels();
    const std::vector<RankedFit> ranking = rankFits({plastic(), plastic()}, options);
    QCOMPARE(ranking.size(), options.models.size());
    for (std::size_t m = 0; m < ranking.size(); ++m) {
      const RankedFit& row = ranking[m];
      const FitResult alone = fit(*plastic(), *options.models[m]);
      QVERIFY(row.fit.model == options.models[m]);
      QVERIFY(row.fit.parameters == alone.parameters);
      QVERIFY(row.fit.errors == alone.errors);
      const RenderedComparison comparison(*plastic(), options.picture);
      const ComparisonPicture picture = comparison.render(*alone.model->instantiate(alone.parameters));
      QVERIFY(picture.image.pixels == row.picture.pixels);
      QCOMPARE(row.renderedSnr, comparison.signalToNoiseRatio(picture));
    }
    QCOMPARE(ranking[0].parameterCount, std::size_t(3));
    QCOMPARE(ranking[1].parameterCount, std::size_t(8));  // two colours, roughness, f0
  }

  /// Of materials with known parameters.
  void rowsFindTheMaterial() {
    const std::vector<RankedFit> glossy = rankFits({plastic(), plastic()}, fewModels());
    const models::ModelSpec& ggx = models::findModel("ggx").spec();
    const auto& found = glossy[1].fit.parameters.values;
    QVERIFY(std::abs(found[*ggx.find("roughness")].x - 0.2) < 1e-3);
    QVERIFY(glm::length(found[*ggx.find("diffuse")] - Rgb(0.05, 0.2, 0.3)) < 1e-3);
    QVERIFY(glossy[1].renderedSnr > 40 && glossy[0].renderedSnr < glossy[1].renderedSnr - 15);
    const Rgb albedo(0.3, 0.2, 0.1);
    const auto matte = bakeTable(test::lambert(albedo), smallGrid);
    const std::vector<RankedFit> ranking = rankFits({matte, matte}, fewModels());
    QVERIFY(glm::length(ranking[0].fit.parameters.values[0] - albedo) < 1e-6);
    for (const RankedFit& row : ranking) QVERIFY2(row.renderedSnr > 80, std::string(row.fit.model->spec().id).c_str());
  }

  void everyRegisteredModelHasItsRow() {
    RankingOptions options = fewModels();
    options.models.clear();
    const auto tiny = bakeTable(*plastic(), {.thetaHCount = 12, .thetaDCount = 8, .phiDCount = 9});
    const std::vector<RankedFit> ranking = rankFits({tiny, tiny}, options);
    QCOMPARE(ranking.size(), models::allModels().size());
    for (const RankedFit& row : ranking) {
      QVERIFY(std::isfinite(row.renderedSnr));
      QCOMPARE(row.parameterCount, fittedParameterCount(row.fit.model->spec()));
    }
  }

  void sortedByMetricOrByPicture() {
    std::vector<RankedFit> ranking = rankFits({plastic(), plastic()}, fewModels());
    ranking.push_back(ranking[0]);
    ranking.back().renderedSnr = std::numeric_limits<double>::quiet_NaN();
    sortRanking(ranking, metrics::BrdfMetric::cubeRoot);
    for (std::size_t i = 1; i < ranking.size(); ++i)
      QVERIFY(ranking[i - 1].fit.errors[std::size_t(metrics::BrdfMetric::cubeRoot)] <=
              ranking[i].fit.errors[std::size_t(metrics::BrdfMetric::cubeRoot)]);
    QCOMPARE(ranking[0].fit.model->spec().id, "ggx");
    sortRanking(ranking, std::nullopt);
    QVERIFY(std::isnan(ranking.back().renderedSnr));
    ranking.pop_back();
    for (std::size_t i = 1; i < ranking.size(); ++i) QVERIFY(ranking[i - 1].renderedSnr >= ranking[i].renderedSnr);
  }

  void progressNeverFallsAndEveryRowIsTold() {
    RankingOptions options = fewModels();
    std::vector<std::string_view> reported;
    options.modelDone = [&](const RankedFit& row) { reported.push_back(row.fit.model->spec().id); };
    double last = 0;
    bool falls = false;
    rankFits({plastic(), plastic()}, options, {{}, [&](double fraction) {
                                                 falls = falls || fraction < last || fraction > 1;
                                                 last = fraction;
                                               }});
    QVERIFY(!falls);
    QCOMPARE(last, 1.0);
    QCOMPARE(reported, (std::vector<std::string_view>{"lambert", "ggx", "blinn-phong"}));
  }

  void cancelReturnsWhatIsDone() {
    for (const std::size_t wanted : {0, 1, 2}) {
      RankingOptions options = fewModels();
      std::stop_source source;
      std::size_t done = 0;
      if (wanted == 0) source.request_stop();
      options.modelDone = [&](const RankedFit&) {
        if (++done == wanted) source.request_stop();
      };
      const std::vector<RankedFit> ranking = rankFits({plastic(), plastic()}, options, {source.get_token(), {}});
      QCOMPARE(ranking.size(), wanted);
      for (const RankedFit& row : ranking) QVERIFY(!row.fit.cancelled);
    }
  }

  void hardCase50SameBitsForAnyThreadCount() {
    const std::vector<RankedFit> two = rankFits({plastic(), plastic()}, fewModels());
    const ThreadLimit limit(1);
    const std::vector<RankedFit> one = rankFits({plastic(), plastic()}, fewModels());
    for (std::size_t m = 0; m < one.size(); ++m) {
      QVERIFY(one[m].fit.parameters == two[m].fit.parameters);
      QCOMPARE(one[m].renderedSnr, two[m].renderedSnr);
    }
  }

  /// 0/0 by contract: not a number, listed at the end of every ranking.
  void hardCase44BlackReference() {
    const auto black = bakeTable(*test::ggx(Rgb(0), Rgb(0), 0.3, 0.04), smallGrid);
    for (const RankedFit& row : rankFits({black, black}, fewModels())) {
      QVERIFY(std::isnan(row.renderedSnr));
      QVERIFY(!row.fit.warnings.empty());
    }
  }
};

GONIO_TEST(FitRankingTest)
}  // namespace fit_ranking_test

#include "fit_ranking_test.moc"
